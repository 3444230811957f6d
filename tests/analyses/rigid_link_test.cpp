// There is a warning for links so stiff that round-off changes accelerations, and none for others.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "analyses/case_run.hpp"
#include "analysis_testing.hpp"
#include "elements/shear_spring.hpp"
#include "paper_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

GroundMotion sine() {
  std::vector<double> samples(101);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = 3.0 * std::sin(0.1 * static_cast<double>(i));
  return {"sine", 0.01, samples};
}

// Two masses on a spring, joined by a link so many times stiffer.
Model joined(double ratio) {
  Model model;
  const NodeId one = add(model, Node{.name = "one", .mass = 500 * tonne});
  const NodeId two = add(model, Node{.name = "two", .mass = 500 * tonne});
  add(model, ShearSpring{.name = "spring", .lower = ground, .upper = one, .stiffness = 1e7 * N / m});
  add(model, ShearSpring{.name = "link", .lower = one, .upper = two, .stiffness = ratio * 1e7 * N / m});
  return model;
}

CaseResult run(Model model, Time end = {}) {
  return run_case(model, sine(), {.transient = {.end = end}, .error_bars = ErrorBarMode::never});
}

bool warns_of_round_off(const CaseResult& result) {
  for (const std::string& warning : result.warnings)
    if (warning.find("round-off") != std::string::npos) return true;
  return false;
}

TEST(RigidLink, OfTrillionsOfTimesTheStiffnessWarns) {
  const CaseResult result = run(joined(3e12), 0.05 * s);
  ASSERT_TRUE(warns_of_round_off(result));
  const std::string& warning = result.warnings.front();
  EXPECT_TRUE(warning.starts_with("The stiffness at \"one\" is so high") ||
              warning.starts_with("The stiffness at \"two\" is so high"))
      << warning;
}

TEST(RigidLink, OfAMillionTimesTheStiffnessIsRightAndDoesNotWarn) {
  for (const double ratio : {1e3, 1e6, 1e8}) {
    SCOPED_TRACE(ratio);
    const CaseResult stiff = run(joined(ratio));
    EXPECT_FALSE(warns_of_round_off(stiff));
    // One node of the mass of both.
    Model rigid;
    const NodeId both = add(rigid, Node{.name = "both", .mass = 1000 * tonne});
    add(rigid, ShearSpring{.name = "spring", .lower = ground, .upper = both, .stiffness = 1e7 * N / m});
    const double right = run(rigid).peaks.at(0).magnitude();
    EXPECT_NEAR(stiff.peaks.at(0).magnitude(), right, (1.0 / ratio + TransientOptions{}.tolerance) * right);
  }
}

TEST(RigidLink, OrdinaryModelsDoNotWarn) {
  Model model;
  add(model, Moat{.around = add(model, paper_building()).base, .clearance = 2 * cm, .law = paper_hertz_damp()});
  EXPECT_FALSE(warns_of_round_off(run(model)));
  Model fixed;
  add(fixed, paper_building_on_fixed_base());
  EXPECT_FALSE(warns_of_round_off(run(fixed)));
}

}  // namespace
}  // namespace moat
