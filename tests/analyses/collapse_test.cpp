// A building without lateral stiffness falls, and the analysis says so.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analyses/case_run.hpp"
#include "analysis_testing.hpp"
#include "elements/spring.hpp"
#include "elements/storey.hpp"
#include "materials/storeys/p_delta.hpp"
#include "materials/storeys/yielding_storey.hpp"
#include "peak_in.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

// The yielding storey keeps 0.8 MN/m, its weight takes 1.6 MN/m.
CaseResult run(double pull, TransientOptions options = {}) {
  Model model;
  const NodeId floor = add(model, Node{.name = "floor", .mass = 500 * tonne});
  add(model,
      Storey<YieldingStorey>{.name = "storey",
                             .lower = ground,
                             .upper = floor,
                             .law = {.stiffness = 40 * MN / m, .yield_force = 0.4 * MN, .hardening_ratio = 0.02}});
  add(model,
      Spring<PDelta>{.name = "weight", .lower = ground, .upper = floor, .law = {.weight = 4.9 * MN, .height = 3 * m}});
  return run_case(model, constant_acceleration(pull, 60 * s), {.transient = options});
}

double peak_drift(const CaseResult& result) { return peak(result, "drift"); }

TEST(Collapse, EndsTheAnalysisWithAWarning) {
  for (const Integrator& integrator : {Integrator{Newmark{}}, Integrator{ExactBetweenEvents{}}}) {
    const CaseResult result = run(2.0, {.integrator = integrator});
    ASSERT_FALSE(result.warnings.empty());
    EXPECT_EQ(result.warnings.front().find("The model collapsed: at t = "), 0U) << result.warnings.front();
    EXPECT_NE(result.warnings.front().find("\"storey\""), std::string::npos) << result.warnings.front();
    EXPECT_GT(peak_drift(result), CollapseGuard::largest_deformation);
    EXPECT_LT(peak_drift(result), 2.0 * CollapseGuard::largest_deformation);
    EXPECT_LT(result.histories.values("time").back(), 60.0);
  }
}

TEST(Collapse, IsSeenBeforeItEndsTheAnalysis) {
  const double fallen = run(2.0).histories.values("time").back();
  // It grows by a factor e in about 0.8 s.
  const CaseResult result = run(2.0, {.end = (fallen - 1.5) * s});
  EXPECT_GT(peak_drift(result), 3.0);
  EXPECT_LT(peak_drift(result), CollapseGuard::largest_deformation);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_EQ(result.warnings.front().find("The model collapsed: the drift of \"storey\" reached "), 0U)
      << result.warnings.front();
}

TEST(Collapse, IsNotSeenWhereTheBuildingStands) {
  const CaseResult result = run(0.3);
  EXPECT_LT(peak_drift(result), 0.02);
  for (const std::string& warning : result.warnings) EXPECT_EQ(warning.find("collapse"), std::string::npos) << warning;
}

// A body that flies is none.
TEST(Collapse, IsNotSeenInABodyThatFlies) {
  Model model;
  add(model, Node{.name = "body", .mass = 1 * kg, .initial_velocity = 10 * m / s});
  Transient analysis{model, still_ground(60 * s)};
  analysis.run();
  EXPECT_NEAR(model.state().displacement[0], 600.0, 1e-6);
}

}  // namespace
}  // namespace moat
