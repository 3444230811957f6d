#include "output/recorders/clearance_recorder.hpp"

#include <gtest/gtest.h>

#include "recorders_testing.hpp"

namespace moat {
namespace {

using testing_output::HandMovedBuilding;

// The moat is 10 cm wide on both sides.
TEST(ClearanceRecorder, KeepsTheSmallestOpeningOfEveryGap) {
  HandMovedBuilding building;
  ClearanceRecorder recorder{building.model};
  recorder.start(building.move(0.0, 0.0, 0.0));
  recorder.step(building.move(1.0, 0.06, 0.0, 0.0, 0.0, 0.0, true, 0.0));
  recorder.step(building.move(2.0, -0.12, 0.0, 0.0, 0.0, 0.0, true, 0.0));
  recorder.step(building.move(3.0, 0.0, 0.0, 0.0, 0.0, 0.0, true, 0.0));
  const std::vector<GapClearance> found = recorder.clearances();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].where, "moat left");
  EXPECT_EQ(found[0].clearance, 0.1);
  EXPECT_NEAR(found[0].left, -0.02, 1e-15) << "indented by 2 cm";
  EXPECT_EQ(found[0].time, 2.0);
  EXPECT_EQ(found[1].where, "moat right");
  EXPECT_NEAR(found[1].left, 0.04, 1e-15);
  EXPECT_EQ(found[1].time, 1.0);
}

TEST(ClearanceRecorder, FindsTheNearestApproachBetweenSteps) {
  HandMovedBuilding building;
  ClearanceRecorder recorder{building.model};
  const auto base = [](double t) { return 0.08 - 0.5 * (t - 0.33) * (t - 0.33); };
  const auto at = [&](double t) { return building.move(t, base(t), 0.0, 0.0, 0.0, 0.0, true, -(t - 0.33)); };
  recorder.start(at(0.0));
  for (const double t : {0.2, 0.4, 0.6}) recorder.step(at(t));
  EXPECT_NEAR(recorder.clearances()[1].left, 0.02, 1e-14);
  EXPECT_NEAR(recorder.clearances()[1].time, 0.33, 1e-13);
}

TEST(ClearanceRecorder, AGapThatNobodyApproachesKeepsItsClearance) {
  HandMovedBuilding building;
  ClearanceRecorder recorder{building.model};
  recorder.start(building.move(0.0, 0.0, 0.0));
  recorder.step(building.move(1.0, -0.05, 0.0));
  EXPECT_EQ(recorder.clearances()[1].left, 0.1);
  EXPECT_EQ(recorder.clearances()[1].time, 0.0);
}

}  // namespace
}  // namespace moat
