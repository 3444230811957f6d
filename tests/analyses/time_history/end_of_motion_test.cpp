// A ground that stops at once after its last sample: the motion from there on is a free vibration.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analyses/case/case_run.hpp"
#include "analysis_testing.hpp"
#include "elements/line/shear_spring.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

constexpr double frequency = std::numbers::pi;             // T = 2 s
constexpr double ground_acceleration = 3.0, pushed = 0.2;  // m/s^2, s

// While the ground accelerates u = -(a/w^2) (1 - cos wt); the free vibration then has the amplitude
// 2 (a/w^2) sin(w t/2), first reached a quarter of a period or less later.
const double amplitude = 2.0 * ground_acceleration / (frequency * frequency) * std::sin(0.5 * frequency * pushed);

// Of the peak displacement, relative.
double error(Time sample_interval, TransientOptions options) {
  Model model = oscillator({.frequency = frequency});
  options.end = 3 * s;
  const CaseResult result = run_case(model, constant_acceleration(ground_acceleration, pushed * s, sample_interval),
                                     {.transient = options, .error_bars = ErrorBarMode::never});
  EXPECT_EQ(result.peaks.at(0).quantity, "displacement");
  return result.peaks.at(0).magnitude() / amplitude - 1.0;
}

TEST(EndOfMotion, AdaptedStepsKeepTheirAccuracy) {
  // A step may err by the tolerance times the acceleration. A ramp of one step would be 1 % of the peak.
  for (const Time interval : {5 * ms, 10 * ms, 20 * ms}) {
    SCOPED_TRACE(interval.si());
    EXPECT_LT(std::abs(error(interval, {})), TransientOptions{}.tolerance);
    EXPECT_LT(std::abs(error(interval, {.tolerance = 1e-7})), 1e-7);
  }
}

TEST(EndOfMotion, FixedStepsAreOfSecondOrder) {
  // The period of average acceleration is long by (w h)^2/12 of itself, and 2 sin(w t/2) small by as much at most.
  // Three samples around a peak miss it by (w h)^4/64 or less.
  double before = 0.0;
  for (const Time step : {20 * ms, 10 * ms, 5 * ms}) {
    SCOPED_TRACE(step.si());
    const double phase = frequency * step.si();
    const double now = std::abs(error(step, {.step = step}));
    EXPECT_LT(now, phase * phase / 12.0 + std::pow(phase, 4));
    if (before > 0.0) {
      EXPECT_NEAR(order(before, now), 2.0, 0.2);
    }
    before = now;
  }
}

TEST(EndOfMotion, ExactStepsAreExact) {
  // The peak lies between steps; a cubic through values and rates at both ends of one misses it by (w h)^4/384.
  for (const Time interval : {5 * ms, 10 * ms, 20 * ms})
    EXPECT_LT(std::abs(error(interval, {.integrator = ExactBetweenEvents{}})),
              std::pow(frequency * interval.si(), 4) / 384.0 + 1e-13);
}

}  // namespace
}  // namespace moat
