#include "output/peaks/peak_recorder.hpp"

#include <gtest/gtest.h>

#include "recorders_testing.hpp"

namespace moat {
namespace {

using testing_output::HandMovedBuilding;

Peak peak(const PeakRecorder& recorder, const std::string& quantity, const std::string& where) {
  Peak found;
  int count = 0;
  for (const Peak& candidate : recorder.peaks())
    if (candidate.quantity == quantity && candidate.where == where) {
      found = candidate;
      ++count;
    }
  EXPECT_EQ(count, 1) << quantity << " " << where;
  return found;
}

TEST(PeakRecorder, FindsPeaksBetweenSteps) {
  HandMovedBuilding building;
  PeakRecorder recorder{building.model};
  const auto base = [](double t) { return 0.08 - 0.5 * (t - 0.33) * (t - 0.33); };
  const auto at = [&](double t) { return building.move(t, base(t), 0.0, 0.0, 0.0, 0.0, true, -(t - 0.33)); };
  recorder.start(at(0.0));
  for (const double t : {0.2, 0.4, 0.6}) recorder.step(at(t));
  const Peak found = peak(recorder, "displacement", "base");
  EXPECT_NEAR(found.value, 0.08, 1e-14);
  EXPECT_NEAR(found.time, 0.33, 1e-13);
  EXPECT_EQ(found.unit, "m");
}

TEST(PeakRecorder, ElementsOfOnePlaceShareAPeak) {
  HandMovedBuilding building;
  PeakRecorder recorder{building.model};
  recorder.start(building.move(0.0, 0.0, 0.0));
  recorder.step(building.move(1.0, 0.13, 0.0));
  recorder.step(building.move(2.0, -0.17, 0.0));
  recorder.step(building.move(3.0, -0.16, 0.0));
  // 7 cm and a little on the left, 3 cm on the right.
  EXPECT_GE(peak(recorder, "indentation", "moat").value, 0.07);
  EXPECT_LT(peak(recorder, "indentation", "moat").value, 0.09);
  EXPECT_EQ(peak(recorder, "indentation", "moat").side, "moat left");
  EXPECT_LT(peak(recorder, "displacement", "base").value, 0.0);
  EXPECT_EQ(peak(recorder, "displacement", "base").side, "left");
  for (const Peak& found : recorder.peaks()) {
    EXPECT_NE(found.where, "moat left");
    EXPECT_NE(found.where, "moat right");
  }
}

TEST(PeakRecorder, BothValuesOfAnEventCount) {
  for (const bool before_is_larger : {true, false}) {
    HandMovedBuilding building;
    PeakRecorder recorder{building.model};
    recorder.start(building.move(0.0, 0.0, 0.0));
    recorder.step(building.move(1.0, 0.0, 0.0, before_is_larger ? 9.0 : 1.0));
    recorder.event(building.move(1.0, 0.0, 0.0, before_is_larger ? -1.0 : -9.0), {});
    recorder.step(building.move(2.0, 0.0, 0.0, -0.5));
    const Peak found = peak(recorder, "absolute_acceleration", "base");
    EXPECT_EQ(found.value, before_is_larger ? 9.0 : -9.0);
    EXPECT_EQ(found.side, before_is_larger ? "right" : "left");
    EXPECT_EQ(found.time, 1.0);
  }
}

TEST(PeakRecorder, AddsUpTheMaximaOfFloorInertia) {
  HandMovedBuilding building;
  PeakRecorder recorder{building.model};
  recorder.start(building.move(0.0, 0.0, 0.0));
  recorder.step(building.move(1.0, 0.0, 0.0, 3.0, 0.0, 1.0));  // base: 4 m/s^2
  recorder.event(building.move(1.0, 0.0, 0.0, 0.0, 0.0), {});
  recorder.step(building.move(2.0, 0.0, 0.0, 0.0, -6.0, 1.0));  // floor: -5 m/s^2
  const Peak sum = peak(recorder, "sum_of_floor_inertia_maxima", "base");
  EXPECT_DOUBLE_EQ(sum.value, 2.0 * 4.0 + 3.0 * 5.0);
  EXPECT_EQ(sum.time, 2.0);
  EXPECT_EQ(sum.unit, "N");
  // The total base shear is that of one instant: |2 * 1 - 3 * 5| = 13 N.
  EXPECT_DOUBLE_EQ(peak(recorder, "total_base_shear", "base").magnitude(), 13.0);
  EXPECT_EQ(sum.side, "");
}

}  // namespace
}  // namespace moat
