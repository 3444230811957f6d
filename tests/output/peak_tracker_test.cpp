#include "output/peak_tracker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace moat {
namespace {

TEST(PeakTracker, FindsTheVertexOfAParabolaExactly) {
  const auto parabola = [](double t) { return 3.0 - 2.0 * (t - 0.37) * (t - 0.37); };
  PeakTracker tracker;
  for (const double t : {0.0, 0.2, 0.4, 0.6, 0.8}) tracker.add(t, parabola(t));
  EXPECT_NEAR(tracker.magnitude(), 3.0, 1e-14);
  EXPECT_NEAR(tracker.time(), 0.37, 1e-13);
}

TEST(PeakTracker, FindsANegativePeakAsMagnitude) {
  PeakTracker tracker;
  for (const double t : {0.0, 0.2, 0.4, 0.6}) tracker.add(t, -3.0 + 2.0 * (t - 0.37) * (t - 0.37));
  EXPECT_NEAR(tracker.magnitude(), 3.0, 1e-14);
  EXPECT_NEAR(tracker.time(), 0.37, 1e-13);
}

TEST(PeakTracker, FindsTheVertexBetweenStepsOfAnyLength) {
  // Every combination of step lengths, with the vertex anywhere, also in the middle between two equal samples.
  for (const double before : {0.01, 0.3, 1.0, 1.7, 50.0})
    for (const double after : {0.01, 0.3, 1.0, 1.7, 50.0})
      for (const double position : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        // The vertex between the second and the third sample; a far fourth one closes the case of 1.
        const double vertex = before + position * after;
        const auto parabola = [&](double t) { return 2.0 - (t - vertex) * (t - vertex); };
        PeakTracker tracker;
        for (const double t : {0.0, before, before + after, before + after + 60.0}) tracker.add(t, parabola(t) + 1e4);
        EXPECT_NEAR(tracker.magnitude(), 1e4 + 2.0, 1e-9) << before << " " << after << " " << position;
        EXPECT_NEAR(tracker.time(), vertex, 1e-5 * (before + after + 60.0))
            << before << " " << after << " " << position;
      }
}

TEST(PeakTracker, FindsALaterVertexThatIsHigherByLittle) {
  // The samples of the second hump stay below the first peak; its vertex does not.
  PeakTracker tracker;
  tracker.add(0.0, 0.0);
  tracker.add(1.0, 2.3);
  tracker.add(2.0, 0.0);
  const auto hump = [](double t) { return 2.5 - (t - 10.0) * (t - 10.0); };
  tracker.restart(8.99, hump(8.99));
  for (const double t : {9.0, 11.0, 11.01}) tracker.add(t, hump(t));
  EXPECT_NEAR(tracker.magnitude(), 2.5, 1e-9);
  EXPECT_NEAR(tracker.time(), 10.0, 1e-9);
}

double error_of_sine_peak(double step) {
  double largest = 0.0;
  // Whatever the phase of sampling.
  for (int phase = 0; phase < 20; ++phase) {
    PeakTracker tracker;
    for (double t = -phase / 20.0 * step; t < 3.0; t += step) tracker.add(t, std::sin(t));
    largest = std::max(largest, std::abs(tracker.magnitude() - 1.0));
  }
  return largest;
}

TEST(PeakTracker, FindsTheTopOfASineToAtLeastThirdOrder) {
  EXPECT_LT(error_of_sine_peak(0.1), 0.1 * 0.1 * 0.1 / 8.0);
  EXPECT_GT(std::log2(error_of_sine_peak(0.2) / error_of_sine_peak(0.1)), 2.9);
}

TEST(PeakTracker, DoesNotReachAcrossARestart) {
  // 0, 1 | 1, 0 would have its parabola's vertex above 1 if the jump were taken for a curve.
  PeakTracker tracker;
  tracker.add(0.0, 0.0);
  tracker.add(1.0, 1.0);
  tracker.restart(1.0, 0.9);
  tracker.add(2.0, 0.2);
  tracker.add(3.0, -0.4);
  EXPECT_EQ(tracker.magnitude(), 1.0);
  EXPECT_EQ(tracker.time(), 1.0);
}

TEST(PeakTracker, CountsBothValuesOfAJump) {
  PeakTracker before, after;
  for (PeakTracker* tracker : {&before, &after}) {
    tracker->add(0.0, 0.5);
    tracker->add(1.0, tracker == &before ? 7.0 : 1.0);
    tracker->restart(1.0, tracker == &before ? -1.0 : -7.0);
    tracker->add(2.0, 0.5);
    EXPECT_EQ(tracker->magnitude(), 7.0);
    EXPECT_EQ(tracker->time(), 1.0);
  }
}

TEST(PeakTracker, AConstantOrMonotonousQuantityHasItsPeakAtASample) {
  PeakTracker constant;
  for (const double t : {0.0, 1.0, 2.0, 3.0}) constant.add(t, -4.0);
  EXPECT_EQ(constant.magnitude(), 4.0);
  EXPECT_EQ(constant.time(), 0.0);
  PeakTracker rising;
  for (const double t : {0.0, 1.0, 2.0, 3.0}) rising.add(t, t * t);
  EXPECT_EQ(rising.magnitude(), 9.0);
  EXPECT_EQ(rising.time(), 3.0);
}

TEST(PeakTracker, APlateauIsNoHigherThanItsSamples) {
  // The force of a bearing without hardening; the parabola through its corner would rise above.
  for (const double sign : {1.0, -1.0}) {
    PeakTracker tracker;
    double t = 0.0;
    for (const double value : {1.0, 4.0, 4.0, 4.0, 4.0, 1.0}) tracker.add(t += 1.0, sign * value);
    EXPECT_EQ(tracker.magnitude(), 4.0);
    EXPECT_EQ(tracker.time(), 2.0);
  }
}

TEST(PeakTracker, RepeatedInstantsDoNoHarm) {
  PeakTracker tracker;
  for (const auto& [t, value] : {std::pair{0.0, 1.0}, {1.0, 2.0}, {1.0, 2.0}, {2.0, 1.0}, {2.0, 1.5}, {3.0, 0.0}})
    tracker.add(t, value);
  EXPECT_TRUE(std::isfinite(tracker.magnitude()));
  EXPECT_GE(tracker.magnitude(), 2.0);
  EXPECT_LT(tracker.magnitude(), 2.5);
}

TEST(PeakTracker, WithoutSamplesThereIsNothing) {
  const PeakTracker tracker;
  EXPECT_EQ(tracker.magnitude(), 0.0);
  EXPECT_EQ(tracker.time(), 0.0);
}

}  // namespace
}  // namespace moat
