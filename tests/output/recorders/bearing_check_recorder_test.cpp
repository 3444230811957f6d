#include "output/recorders/bearing_check_recorder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "elements/line/isolator.hpp"
#include "elements/line/spring.hpp"
#include "elements/plan/planar_spring.hpp"
#include "materials/linear.hpp"
#include "materials/plan/biaxial_linear.hpp"
#include "message_of.hpp"
#include "model/analysis_state.hpp"
#include "moved_model.hpp"
#include "recorders_testing.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

const RubberBearing rubber{
    .diameter = 0.7 * m, .layer_thickness = 6 * mm, .rubber_thickness = 0.18 * m, .shear_modulus = 0.5 * MPa};

BearingDemand found(const std::vector<BearingCheckRow>& rows, std::string_view bearing, std::string_view check) {
  const auto row = std::ranges::find_if(
      rows, [&](const BearingCheckRow& each) { return each.bearing == bearing && each.demand.check == check; });
  EXPECT_NE(row, rows.end()) << bearing << ", " << check;
  return row == rows.end() ? BearingDemand{} : row->demand;
}

TEST(BearingCheckRecorder, KeepsTheLargestRatioOfEveryElementWithCapacities) {
  testing_output::HandMovedBuilding building;
  BearingCheckRecorder recorder{
      CheckRules::none,
      {{"bearings", {.displacement_capacity = 0.5 * m}},
       {"damper", {.stroke = 0.2 * m, .speed_capacity = 1 * m / s, .force_capacity = 1 * N}}}};
  recorder.start(building.move(0.0, 0.0, 0.0));
  recorder.step(building.move(1.0, -0.06, 0.02));
  recorder.event(building.move(1.0, -0.06, 0.04), {});
  recorder.step(building.move(2.0, 0.05, 0.0));
  const std::vector<BearingCheckRow> rows = recorder.rows();
  const BearingDemand displacement = found(rows, "bearings", "displacement");
  EXPECT_NEAR(displacement.ratio(), 0.12, 1e-15);
  EXPECT_EQ(displacement.time, 1.0);
  EXPECT_NEAR(found(rows, "damper", "stroke").ratio(), 0.5, 1e-14) << "after the event";
  EXPECT_NEAR(found(rows, "damper", "speed").demand, 0.01, 1e-15);
  EXPECT_NEAR(found(rows, "damper", "force").ratio(), 0.01, 1e-15);
  EXPECT_EQ(rows.size(), 4U) << "the storey has no capacities";
  EXPECT_EQ(rows.front().type, "Viscous") << "the law of the damper";
}

TEST(BearingCheckRecorder, TakesTheAxialForceOfOneBearing) {
  Model model;
  const NodeId a = add(model, Node{.name = "a", .mass = 32 * MN / g, .initial_displacement = 0.35 * m});
  for (const char* name : {"four", "others"})
    add(model, Isolator<Linear>{.name = name,
                                .upper = a,
                                .law = {.stiffness = 2 * MN / m},
                                .count = 4,
                                .weight = 16 * MN,
                                .at = (name[0] == 'f' ? -1 : 1) * m,
                                .weight_changes = true});
  add(model, Spring<Linear>{.name = "linear", .lower = ground, .upper = a, .law = {.stiffness = 1 * kN / m}});
  add(model, Building{.base = a, .axial_forces = AxialForces{.displaced_weight = false}});
  const AnalysisState state{model};
  BearingCheckRecorder recorder{
      CheckRules::asce, {{"four", {.rubber = rubber, .force_capacity = 1 * MN}}, {"linear", {.rubber = rubber}}}};
  recorder.start({model, state});
  const std::vector<BearingCheckRow> rows = recorder.rows();
  EXPECT_NEAR(found(rows, "four", "stability").ratio(), 4 / 9.4787791, 1e-7);
  EXPECT_NEAR(found(rows, "four", "force").demand, 2e6 * 0.35, 1e-6);
  EXPECT_TRUE(std::isnan(found(rows, "linear", "stability").demand));
  EXPECT_NEAR(found(rows, "linear", "shear strain").demand, 0.35 / 0.18, 1e-14);
}

TEST(BearingCheckRecorder, TakesBothComponentsInPlanAndCapacitiesOfAType) {
  Model model;
  const DiaphragmId floor =
      add(model, Diaphragm{.name = "floor", .mass = 1 * tonne, .rotary_inertia = 1e3 * kg * m * m});
  for (const char* name : {"west", "east"})
    add(model,
        PlanBearing<BiaxialLinear>{.name = name, .under = floor, .law = {.stiffness = 1 * kN / m}, .place = "LRB700"});
  AnalysisState state{model};
  MotionState& trial = state.trial();
  trial.displacement.head(3) << 0.3, -0.4, 0.0;
  trial.velocity.head(3) << -0.6, 0.8, 0.0;
  state.evaluate();
  state.evaluate_rates();
  state.commit();
  BearingCheckRecorder recorder{
      CheckRules::none,
      {{"LRB700", {.displacement_capacity = 1 * m}}, {"east", {.stroke = 1 * m, .force_capacity = 1 * kN}}}};
  recorder.start({model, state});
  const std::vector<BearingCheckRow> rows = recorder.rows();
  EXPECT_NEAR(found(rows, "west", "displacement").ratio(), 0.5, 1e-15);
  EXPECT_NEAR(found(rows, "east", "speed").demand, 1.0, 1e-15) << "its own capacities go first";
  EXPECT_NEAR(found(rows, "east", "force").ratio(), 0.5, 1e-15);
  EXPECT_EQ(rows.front().type, "LRB700");
}

TEST(BearingCheckRecorder, RefusesBadCapacitiesAndUnknownNames) {
  EXPECT_EQ(
      message_of([] {
        BearingCheckRecorder{CheckRules::none, {{"LRB", {.stroke = 0 * m}}}};
      }),
      "BearingCapacities \"LRB\": stroke = 0 m is not allowed; it must be > 0 m and finite. Leave it out where it "
      "is not known.");
  testing_output::HandMovedBuilding building;
  BearingCheckRecorder recorder{CheckRules::none, {{"LRB", {.stroke = 1 * m}}}};
  EXPECT_EQ(message_of([&] { recorder.start(building.move(0.0, 0.0, 0.0)); }),
            "BearingCheckRecorder \"LRB\": no element has this name or type. Give the name of a bearing, or the one "
            "under which its peaks are listed.");
}

}  // namespace
}  // namespace moat
