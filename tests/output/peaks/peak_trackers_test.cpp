#include "output/peaks/peak_trackers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace moat {
namespace {

/// One quantity followed by PeakTrackers.
class One {
 public:
  template <class Inside>
  void add(double time, double value, double rate, const Inside& inside) {
    set(time, value, rate);
    trackers_.add([&](std::size_t, double fraction, double turned) { return inside(fraction, turned); });
  }
  void add(double time, double value, double rate) {
    add(time, value, rate, [](double, double turned) { return turned; });
  }
  void restart(double time, double value, double rate) {
    set(time, value, rate);
    trackers_.restart();
  }
  void add_bend(double time) { trackers_.add_bend(0, time); }

  [[nodiscard]] double value() const { return trackers_.value(0); }
  [[nodiscard]] double magnitude() const { return trackers_.magnitude(0); }
  [[nodiscard]] double time() const { return trackers_.time(0); }

 private:
  void set(double time, double value, double rate) { trackers_.next() = {time, {value}, {rate}}; }

  PeakTrackers trackers_{1};
};

TEST(PeakTrackers, FindsTheVertexBetweenStepsOfAnyLength) {
  for (const double before : {0.01, 0.3, 1.0, 1.7, 50.0})
    for (const double after : {0.01, 0.3, 1.0, 1.7, 50.0})
      for (const double position : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        const double vertex = before + position * after;
        One tracker;
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
    One tracker;
    for (double t = -phase / 20.0 * step; t < 3.0; t += step) tracker.add(t, std::sin(t), std::cos(t));
    largest = std::max(largest, std::abs(tracker.magnitude() - 1.0));
  }
  return largest;
}

TEST(PeakTrackers, FindsTheTopOfASineToFourthOrder) {
  // The error of the cubic is at most h^4/384 of the fourth derivative.
  EXPECT_LT(error_of_sine_peak(0.1), std::pow(0.1, 4) / 384.0);
  EXPECT_GT(std::log2(error_of_sine_peak(0.2) / error_of_sine_peak(0.1)), 3.9);
}

TEST(PeakTrackers, DoesNotReachAcrossARestart) {
  One tracker;
  tracker.add(0.0, 0.0, 1.0);
  tracker.add(1.0, 1.0, 1.0);
  tracker.restart(1.0, 0.9, -0.7);
  tracker.add(2.0, 0.2, -0.7);
  EXPECT_EQ(tracker.magnitude(), 1.0);
  EXPECT_EQ(tracker.time(), 1.0);
}

TEST(PeakTrackers, CountsBothValuesOfAJump) {
  One before, after;
  for (One* tracker : {&before, &after}) {
    tracker->add(0.0, 0.5, 0.0);
    tracker->add(1.0, tracker == &before ? 7.0 : 1.0, 0.0);
    tracker->restart(1.0, tracker == &before ? -1.0 : -7.0, 0.0);
    tracker->add(2.0, 0.5, 0.0);
    EXPECT_EQ(tracker->magnitude(), 7.0);
    EXPECT_EQ(tracker->time(), 1.0);
  }
}

TEST(PeakTrackers, AConstantOrMonotonousQuantityHasItsPeakAtASample) {
  One constant;
  for (const double t : {0.0, 1.0, 2.0, 3.0}) constant.add(t, -4.0, 0.0);
  EXPECT_EQ(constant.magnitude(), 4.0);
  EXPECT_EQ(constant.time(), 0.0);
  One rising;
  for (const double t : {0.0, 1.0, 2.0, 3.0}) rising.add(t, t * t, 2.0 * t);
  EXPECT_EQ(rising.magnitude(), 9.0);
  EXPECT_EQ(rising.time(), 3.0);
}

TEST(PeakTrackers, AnInfiniteSlopeAtOneEndMakesNoPeak) {
  // t^(1/4) from nearly 0 to 1, then falling: the cubic would rise to a hundred times that.
  One tracker;
  const double start = 1e-12;
  tracker.add(start, std::pow(start, 0.25), 0.25 * std::pow(start, -0.75));
  tracker.add(1.0, 1.0, -0.1);
  EXPECT_EQ(tracker.magnitude(), 1.0);
}

TEST(PeakTrackers, RepeatedInstantsDoNoHarm) {
  One tracker;
  for (const auto& [t, value] : {std::pair{0.0, 1.0}, {1.0, 2.0}, {1.0, 2.0}, {2.0, 1.0}, {2.0, 1.5}, {3.0, 0.0}})
    tracker.add(t, value, 1.0 - t);
  EXPECT_TRUE(std::isfinite(tracker.magnitude()));
  EXPECT_GE(tracker.magnitude(), 2.0);
  EXPECT_LT(tracker.magnitude(), 2.5);
}

TEST(PeakTrackers, TellWhoseValueInsideAStepIsAskedFor) {
  PeakTrackers trackers{2};
  trackers.next() = {0.0, {4.0, 0.0}, {1.0, 1.0}};
  trackers.restart();
  trackers.next() = {1.0, {4.0, 1.0}, {-1.0, 1.0}};
  trackers.add([](std::size_t quantity, double fraction, double turned) {
    EXPECT_EQ(quantity, 0U);
    EXPECT_NEAR(turned, 4.25, 1e-12);
    EXPECT_NEAR(fraction, 0.5, 1e-12);
    return 4.125;
  });
  EXPECT_EQ(trackers.value(0), 4.125);
  EXPECT_NEAR(trackers.time(0), 0.5, 1e-12);
  EXPECT_EQ(trackers.value(1), 1.0);
}

TEST(PeakTrackers, AValueBetweenTheInstantsCounts) {
  PeakTrackers trackers{2};
  trackers.next() = {1.0, {1.0, 1.0}, {0.0, 0.0}};
  trackers.restart();
  trackers.keep(1, 0.5, -3.0);
  trackers.keep(1, 0.7, 2.0);
  EXPECT_EQ(trackers.value(0), 1.0);
  EXPECT_EQ(trackers.value(1), -3.0);
  EXPECT_EQ(trackers.time(1), 0.5);
}

/// Straight before and after the bend, so that both extrapolations are exact.
TEST(PeakTrackers, ABendInsideTheLastStepCounts) {
  One tracker;
  tracker.add(0.0, -1.0, -2.0);
  tracker.add(1.0, -3.0, -2.0);
  // Down to -4.2 at 1.6 s, then up by 0.5 per second to -4 at 2 s.
  tracker.add(2.0, -4.0, 0.5, [](double, double) { return 0.0; });
  EXPECT_EQ(tracker.value(), -4.0);
  tracker.add_bend(1.6);
  EXPECT_NEAR(tracker.value(), -4.2, 1e-14);
  EXPECT_EQ(tracker.time(), 1.6);
}

/// The cubic over a step with a bend turns where the quantity does not.
TEST(PeakTrackers, ATurnOfTheCubicOverABendDoesNotCount) {
  One tracker;
  tracker.add(0.0, 0.0, 1.0);
  tracker.add(1.0, 1.0, 1.0);
  // Up to 1.02 at 1.02 s, then down by 1 per second.
  tracker.add(2.0, 0.04, -1.0);
  EXPECT_GT(tracker.value(), 1.05);
  tracker.add_bend(1.02);
  EXPECT_NEAR(tracker.value(), 1.02, 1e-14);
  EXPECT_EQ(tracker.time(), 1.02);
}

/// The force of a contact by Hertz grows like t^1.5, so that both ends of the step do not show the value at the touch.
TEST(PeakTrackers, TheValueAtATouchContinuesThePathBeforeIt) {
  constexpr double h = 0.05, touch = 4.83 * h, hardness = 200.0;
  const auto into = [](double t) { return std::max(t - touch, 0.0); };
  const auto value = [&](double t) { return std::sin(4.0 * t) - hardness * std::pow(into(t), 1.5); };
  const auto rate = [&](double t) { return 4.0 * std::cos(4.0 * t) - 1.5 * hardness * std::sqrt(into(t)); };
  One tracker;
  for (int step = 0; step <= 5; ++step) tracker.add(step * h, value(step * h), rate(step * h));
  tracker.add_bend(touch);
  // The error of the continued cubic is below (4 h)^4 / 6.
  EXPECT_NEAR(tracker.magnitude(), value(touch), std::pow(4.0 * h, 4) / 6.0);
}

/// Smooth paths before and behind a bend turn, too.
TEST(PeakTrackers, TurnsBesideABendCount) {
  const auto parabola = [](double t) { return 3.0 - (t - 1.4) * (t - 1.4); };
  const auto rate = [](double t) { return -2.0 * (t - 1.4); };
  const auto line = [&](double t) { return parabola(1.7) - 2.0 * (t - 1.7); };
  for (const bool turns_first : {true, false}) {
    SCOPED_TRACE(turns_first);
    One tracker;
    const auto add = [&](double t) {
      if (turns_first)
        t <= 1.7 ? tracker.add(t, parabola(t), rate(t)) : tracker.add(t, line(t), -2.0);
      else  // steep line up to 1.1, then the parabola
        t >= 1.1 ? tracker.add(t, parabola(t), rate(t)) : tracker.add(t, parabola(1.1) + 8.0 * (t - 1.1), 8.0);
    };
    for (const double t : {0.8, 1.0, 2.0}) add(t);
    tracker.add_bend(turns_first ? 1.7 : 1.1);
    EXPECT_NEAR(tracker.value(), 3.0, 1e-12);
    EXPECT_NEAR(tracker.time(), 1.4, 1e-12);
  }
}

/// The path of a bent step cannot be continued.
TEST(PeakTrackers, ABendBehindABentStepIsExtrapolatedFromBothEnds) {
  One tracker;
  tracker.add(0.0, 0.0, 4.0);
  tracker.add(1.0, 2.5, 1.0);  // bent at 0.5 s
  tracker.add_bend(0.5);
  tracker.add(2.0, 2.5, -1.0);  // bent at 1.5 s
  tracker.add_bend(1.5);
  EXPECT_NEAR(tracker.value(), 3.0, 1e-12);
  EXPECT_EQ(tracker.time(), 1.5);
}

/// The cubic over a very short step would magnify the round-off of its values a thousand million times.
TEST(PeakTrackers, ABendFarBehindAShortStepIsExtrapolatedFromBothEnds) {
  One tracker;
  tracker.add(0.0, 1.0, 1.0);
  tracker.add(1e-3, 1.001 + 1e-9, 1.0);
  tracker.add(1.0, 1.5, -1.0);  // bent at 0.75 s
  tracker.add_bend(0.75);
  EXPECT_NEAR(tracker.value(), 1.75, 1e-8);
}

/// An event elsewhere has left a short step, over which this quantity went on: the path is that since before the event.
TEST(PeakTrackers, ABendFarBehindAShortStepContinuesThePathOfTheStepsBefore) {
  const auto parabola = [](double t) { return 3.0 - (t - 1.4) * (t - 1.4); };
  const auto rate = [](double t) { return -2.0 * (t - 1.4); };
  for (const double jump : {0.0, 0.5}) {
    SCOPED_TRACE(jump);
    One tracker;
    for (const double t : {0.0, 1.0}) tracker.add(t, parabola(t) - jump, rate(t));
    tracker.restart(1.0, parabola(1.0), rate(1.0));
    tracker.add(1.1, parabola(1.1), rate(1.1));
    tracker.add(1.8, parabola(1.7) - 0.5, -5.0);  // bent at 1.7 s
    tracker.add_bend(1.7);
    if (jump == 0.0)
      EXPECT_NEAR(tracker.value(), 3.0, 1e-12);
    else
      EXPECT_NEAR(tracker.value(), (0.1 * 3.27 + 0.6 * 2.91) / 0.7, 1e-12) << "straight lines from both ends";
  }
}

/// A parabola on both sides of the bend, with one curvature.
TEST(PeakTrackers, ABendIsExtrapolatedWithTheCurvatureBeforeIt) {
  One tracker;
  for (const double t : {0.0, 1.0, 2.0}) tracker.add(t, t * t, 2.0 * t);
  const auto after = [](double t) { return 6.25 - 5.0 * (t - 2.5) + (t - 2.5) * (t - 2.5); };
  tracker.add(3.0, after(3.0), -4.0, [](double, double) { return 0.0; });
  EXPECT_EQ(tracker.magnitude(), 4.0);
  tracker.add_bend(2.5);
  EXPECT_NEAR(tracker.value(), 6.25, 1e-14);
  EXPECT_EQ(tracker.time(), 2.5);
}

TEST(PeakTrackers, ABendOutsideTheLastStepIsLeftAlone) {
  One tracker;
  for (const double t : {0.0, 1.0, 2.0}) tracker.add(t, t, 1.0);
  for (const double t : {0.5, 1.0, 2.0, 2.5}) tracker.add_bend(t);
  EXPECT_EQ(tracker.value(), 2.0);
  EXPECT_EQ(tracker.time(), 2.0);
}

}  // namespace
}  // namespace moat
