#include "output/peaks/peak_tracker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace moat {
namespace {

TEST(PeakTracker, FindsTheVertexOfAParabolaExactly) {
  PeakTracker tracker;
  for (const double t : {0.0, 0.2, 0.4, 0.6, 0.8})
    tracker.add(t, 3.0 - 2.0 * (t - 0.37) * (t - 0.37), -4.0 * (t - 0.37));
  EXPECT_NEAR(tracker.magnitude(), 3.0, 1e-14);
  EXPECT_NEAR(tracker.time(), 0.37, 1e-13);
}

TEST(PeakTracker, FindsANegativePeakAsMagnitude) {
  PeakTracker tracker;
  for (const double t : {0.0, 0.2, 0.4, 0.6}) tracker.add(t, -3.0 + 2.0 * (t - 0.37) * (t - 0.37), 4.0 * (t - 0.37));
  EXPECT_NEAR(tracker.magnitude(), 3.0, 1e-14);
  EXPECT_NEAR(tracker.value(), -3.0, 1e-14);
  EXPECT_NEAR(tracker.time(), 0.37, 1e-13);
}

TEST(PeakTracker, FindsTheVertexBetweenStepsOfAnyLength) {
  for (const double before : {0.01, 0.3, 1.0, 1.7, 50.0})
    for (const double after : {0.01, 0.3, 1.0, 1.7, 50.0})
      for (const double position : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        const double vertex = before + position * after;
        PeakTracker tracker;
        for (const double t : {0.0, before, before + after, before + after + 60.0})
          tracker.add(t, 2.0 - (t - vertex) * (t - vertex) + 1e4, -2.0 * (t - vertex));
        EXPECT_NEAR(tracker.magnitude(), 1e4 + 2.0, 1e-9) << before << " " << after << " " << position;
        EXPECT_NEAR(tracker.time(), vertex, 1e-5 * (before + after + 60.0))
            << before << " " << after << " " << position;
      }
}

double error_of_sine_peak(double step) {
  double largest = 0.0;
  // The bound holds for every phase of sampling.
  for (int phase = 0; phase < 20; ++phase) {
    PeakTracker tracker;
    for (double t = -phase / 20.0 * step; t < 3.0; t += step) tracker.add(t, std::sin(t), std::cos(t));
    largest = std::max(largest, std::abs(tracker.magnitude() - 1.0));
  }
  return largest;
}

TEST(PeakTracker, FindsTheTopOfASineToFourthOrder) {
  // The error of the cubic is at most h^4/384 of the fourth derivative.
  EXPECT_LT(error_of_sine_peak(0.1), std::pow(0.1, 4) / 384.0);
  EXPECT_GT(std::log2(error_of_sine_peak(0.2) / error_of_sine_peak(0.1)), 3.9);
}

TEST(PeakTracker, DoesNotReachAcrossARestart) {
  PeakTracker tracker;
  tracker.add(0.0, 0.0, 1.0);
  tracker.add(1.0, 1.0, 1.0);
  tracker.restart(1.0, 0.9, -0.7);
  tracker.add(2.0, 0.2, -0.7);
  EXPECT_EQ(tracker.magnitude(), 1.0);
  EXPECT_EQ(tracker.time(), 1.0);
}

TEST(PeakTracker, CountsBothValuesOfAJump) {
  PeakTracker before, after;
  for (PeakTracker* tracker : {&before, &after}) {
    tracker->add(0.0, 0.5, 0.0);
    tracker->add(1.0, tracker == &before ? 7.0 : 1.0, 0.0);
    tracker->restart(1.0, tracker == &before ? -1.0 : -7.0, 0.0);
    tracker->add(2.0, 0.5, 0.0);
    EXPECT_EQ(tracker->magnitude(), 7.0);
    EXPECT_EQ(tracker->time(), 1.0);
  }
}

TEST(PeakTracker, AConstantOrMonotonousQuantityHasItsPeakAtASample) {
  PeakTracker constant;
  for (const double t : {0.0, 1.0, 2.0, 3.0}) constant.add(t, -4.0, 0.0);
  EXPECT_EQ(constant.magnitude(), 4.0);
  EXPECT_EQ(constant.time(), 0.0);
  PeakTracker rising;
  for (const double t : {0.0, 1.0, 2.0, 3.0}) rising.add(t, t * t, 2.0 * t);
  EXPECT_EQ(rising.magnitude(), 9.0);
  EXPECT_EQ(rising.time(), 3.0);
}

TEST(PeakTracker, AsksForTheValueThatCountsInsideAStep) {
  // A force that is cut off at 4: the cubic through its ends rises to 4.25, the law does not.
  PeakTracker tracker;
  const auto law = [](double fraction, double turned) {
    EXPECT_NEAR(fraction, 0.5, 1e-12);
    EXPECT_NEAR(turned, 4.25, 1e-12);
    return 4.0;
  };
  tracker.add(0.0, 4.0, 1.0);
  tracker.add(1.0, 4.0, -1.0, law);
  EXPECT_EQ(tracker.magnitude(), 4.0);
}

TEST(PeakTracker, AnInfiniteSlopeAtOneEndMakesNoPeak) {
  // t^(1/4) from nearly 0 to 1, then falling: the cubic would rise to a hundred times that.
  PeakTracker tracker;
  const double start = 1e-12;
  tracker.add(start, std::pow(start, 0.25), 0.25 * std::pow(start, -0.75));
  tracker.add(1.0, 1.0, -0.1);
  EXPECT_EQ(tracker.magnitude(), 1.0);
}

TEST(PeakTracker, RepeatedInstantsDoNoHarm) {
  PeakTracker tracker;
  for (const auto& [t, value] : {std::pair{0.0, 1.0}, {1.0, 2.0}, {1.0, 2.0}, {2.0, 1.0}, {2.0, 1.5}, {3.0, 0.0}})
    tracker.add(t, value, 1.0 - t);
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
