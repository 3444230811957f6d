// Tolerances at and below round-off.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "analysis_testing.hpp"
#include "message_of.hpp"
#include "paper_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

TEST(TightTolerance, BelowRoundOffIsRefused) {
  for (const double tolerance : {1e-17, 1e-300, 0.9e-12}) {
    Model model;
    add(model, Node{.name = "body", .mass = 1 * kg});
    EXPECT_NE(message_of([&] {
                Transient(model, still_ground(1 * s), {.tolerance = tolerance});
              }).find("it must be >= 1e-12 and < 1"),
              std::string::npos)
        << tolerance;
  }
}

TEST(TightTolerance, TightWithBearingsThatAreNotLocatedEnds) {
  std::vector<double> samples(401);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = 4.0 * std::sin(0.05 * static_cast<double>(i));
  Model model;
  ShearBuilding building = paper_building();
  building.isolation = unlocated_paper_bearings();
  add(model, building);
  const CaseResult result = run_case(model, GroundMotion{"sine", 0.01, samples},
                                     {.transient = {.tolerance = 1e-7}, .error_bars = ErrorBarMode::never});
  EXPECT_EQ(result.histories.rows(), samples.size());
  // An error of acceleration of (w h)^3/72 = 1e-7 in the fastest vibration, w^2 < 4 k/m, needs 15,000 steps of 0.27 ms.
  // Corners must not cost more than that again.
  EXPECT_LT(result.solver.accepted_steps, 30000);
}

}  // namespace
}  // namespace moat
