// Motions scaled to a measure of intensity.

#include "motions/scaling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "base/units.hpp"
#include "message_of.hpp"
#include "motions/near_fault_pulse.hpp"
#include "motions/response_spectrum.hpp"

namespace moat {
namespace {

using namespace units;

const GroundMotion slow = near_fault_pulse({.pulse_period = 1.7 * s});
const GroundMotion fast = near_fault_pulse({.pulse_period = 0.6 * s}).scaled_by(0.3);

TEST(Scaling, GivesTheMeasureItsTarget) {
  for (const GroundMotion& motion : {slow, fast}) {
    EXPECT_NEAR(scaled_to_pgv(motion, 0.7 * m / s).peak_velocity().si(), 0.7, 1e-12);
    const GroundMotion at_two = scaled_to_sa(motion, 2 * s, 0.5 * g);
    EXPECT_NEAR(response_spectrum(at_two, {2 * s}, 0.05).pseudo_acceleration[0], 0.5 * g.si(), 1e-11);
    const std::vector<Time> periods = periods_around(2 * s);
    const auto sa = response_spectrum(scaled_to_average_sa(motion, periods, 0.3 * g), periods, 0.05);
    double product = 1.0;
    for (const double each : sa.pseudo_acceleration) product *= each;
    EXPECT_NEAR(std::pow(product, 1.0 / static_cast<double>(periods.size())), 0.3 * g.si(), 1e-11);
  }
}

TEST(Scaling, AveragesFromAFifthToThreeTimesThePeriod) {
  const std::vector<Time> periods = periods_around(2 * s);
  EXPECT_NEAR(periods.front().si(), 0.4, 1e-15);
  EXPECT_NEAR(periods.back().si(), 6.0, 1e-14);
  EXPECT_NEAR(periods[1].si() / periods[0].si(), periods[9].si() / periods[8].si(), 1e-14);
}

TEST(Scaling, OfAPairHasOneFactorAndTheGeometricMean) {
  const PlanMotion pair{slow, fast, 30 * deg};
  const auto check = [&](const PlanMotion& scaled, auto measure, double target) {
    EXPECT_NEAR(std::sqrt(measure(scaled.first) * measure(scaled.second)), target, 1e-11 * target);
    EXPECT_NEAR(scaled.first.scale_factor() / pair.first.scale_factor(),
                scaled.second.scale_factor() / pair.second.scale_factor(), 1e-14);
    EXPECT_EQ(scaled.incidence, pair.incidence);
  };
  check(
      scaled_to_pga(pair, 4 * m / s / s), [](const GroundMotion& each) { return each.peak_acceleration().si(); }, 4.0);
  check(
      scaled_to_pgv(pair, 2 * m / s), [](const GroundMotion& each) { return each.peak_velocity().si(); }, 2.0);
  check(
      scaled_to_sa(pair, 1 * s, 3 * m / s / s),
      [](const GroundMotion& each) { return spectral_acceleration(each, 1 * s).si(); }, 3.0);
  const std::vector<Time> periods{0.5 * s, 1 * s};
  check(
      scaled_to_average_sa(pair, periods, 3 * m / s / s),
      [&](const GroundMotion& each) { return average_spectral_acceleration(each, periods).si(); }, 3.0);
}

TEST(Scaling, RefusesAMotionThatIsZeroAndATargetThatIsNotPositive) {
  const GroundMotion still{"still", 0.01, {0.0, 0.0, 0.0}};
  EXPECT_NE(testing::message_of<InputError>([&] { scaled_to_sa(still, 1 * s, 1 * g); }).find("is zero"),
            std::string::npos);
  EXPECT_THROW(scaled_to_pgv(slow, -1 * m / s), InputError);
  EXPECT_THROW(scaled_to_sa(slow, 1 * s, 0 * g), InputError);
  EXPECT_THROW((void)average_spectral_acceleration(slow, {}), InputError);
}

}  // namespace
}  // namespace moat
