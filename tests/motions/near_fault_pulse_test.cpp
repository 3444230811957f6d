#include "motions/near_fault_pulse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "motion_files.hpp"

namespace moat {
namespace {

using namespace units;
using std::numbers::pi;

double middle_of(const NearFaultPulse& pulse) {
  return pulse.lead_in.si() + pulse.oscillation_ratio * pulse.pulse_period.si() / 2.0;
}

double closed_form_velocity(const NearFaultPulse& pulse, double time) {
  const double angle = 2.0 * pi * (time - middle_of(pulse)) / pulse.pulse_period.si();
  if (std::abs(angle) > pi * pulse.oscillation_ratio) return 0.0;
  return pulse.amplitude.si() / 2.0 * (1.0 + std::cos(angle / pulse.oscillation_ratio)) * std::cos(angle + pulse.phase);
}

/// The integral of the closed-form velocity, from the products of its cosines.
double closed_form_permanent_displacement(const NearFaultPulse& pulse) {
  const double w = 2.0 * pi / pulse.pulse_period.si();
  const double slow = w / pulse.oscillation_ratio;
  const double end = pi / slow;
  return pulse.amplitude.si() / 2.0 * std::cos(pulse.phase) *
         (2.0 * std::sin(w * end) / w + std::sin((w - slow) * end) / (w - slow) +
          std::sin((w + slow) * end) / (w + slow));
}

double velocity_error(NearFaultPulse pulse, Time time_step) {
  pulse.time_step = time_step;
  const GroundMotion motion = near_fault_pulse(pulse);
  const std::vector<double> velocity = motion.velocity();
  double error = 0.0;
  for (std::size_t i = 0; i < velocity.size(); ++i)
    error = std::max(error,
                     std::abs(velocity[i] - closed_form_velocity(pulse, static_cast<double>(i) * motion.time_step())));
  return error;
}

TEST(NearFaultPulse, IntegratesToItsClosedFormVelocityWithSecondOrder) {
  for (const NearFaultPulse& pulse : {NearFaultPulse{}, NearFaultPulse{.oscillation_ratio = 1.5, .phase = pi / 2},
                                      NearFaultPulse{.oscillation_ratio = 3.0, .phase = -2.0}}) {
    const double coarse = velocity_error(pulse, 0.02 * s);
    const double fine = velocity_error(pulse, 0.01 * s);
    EXPECT_LT(coarse, 2e-3 * pulse.amplitude.si());
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05);
  }
}

TEST(NearFaultPulse, HasTheDocumentedPeaksByDefault) {
  const GroundMotion motion = near_fault_pulse();
  EXPECT_NEAR(motion.peak_acceleration() / g, 0.385, 0.001);
  EXPECT_NEAR(motion.peak_velocity() / (cm / s), 77.0, 0.5);
  EXPECT_NEAR((motion.peak_velocity() / motion.peak_acceleration()) / s, 0.205, 0.001);
  EXPECT_NEAR(motion.duration(), 20.0, 1e-9);
}

TEST(NearFaultPulse, PeaksAtItsAmplitudeForPhaseZero) {
  const GroundMotion motion = near_fault_pulse({.amplitude = 0.5 * (m / s), .phase = 0.0, .time_step = 0.001 * s});
  EXPECT_NEAR(motion.peak_velocity().si(), 0.5, 0.5 * 1e-5);
}

TEST(NearFaultPulse, StartsAndEndsAtRest) {
  const NearFaultPulse parameters;
  const GroundMotion motion = near_fault_pulse(parameters);
  const double end = middle_of(parameters) + parameters.oscillation_ratio * parameters.pulse_period.si() / 2.0;
  for (std::size_t i = 0; i < motion.samples().size(); ++i) {
    const double time = static_cast<double>(i) * motion.time_step();
    if (time <= parameters.lead_in.si() || time >= end + 1e-9) {
      EXPECT_EQ(motion.samples()[i], 0.0) << time;
    }
  }
  EXPECT_EQ(near_fault_pulse({.lead_in = 0 * s}).samples()[0], 0.0);
}

double residual_velocity(double oscillation_ratio, Time time_step) {
  return near_fault_pulse({.oscillation_ratio = oscillation_ratio, .time_step = time_step, .lead_in = 1.3 * s})
      .velocity()
      .back();
}

// The acceleration is then a sum of whole cosine periods, which the trapezoidal rule integrates to zero.
TEST(NearFaultPulse, LeavesNoResidualVelocityForAWholeOscillationRatio) {
  for (const double ratio : {2.0, 3.0})
    for (const Time time_step : {0.065 * s, 0.0325 * s, 0.005 * s})
      EXPECT_NEAR(residual_velocity(ratio, time_step), 0.0, 1e-13);
}

TEST(NearFaultPulse, LeavesAResidualVelocityOfSecondOrderOtherwise) {
  const double coarse = residual_velocity(1.5, 0.065 * s);
  const double fine = residual_velocity(1.5, 0.0325 * s);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05);
}

double permanent_displacement_error(NearFaultPulse pulse, Time time_step) {
  pulse.time_step = time_step;
  return std::abs(near_fault_pulse(pulse).displacement().back() - closed_form_permanent_displacement(pulse));
}

TEST(NearFaultPulse, ComesBackForAWholeOscillationRatioAndStaysDisplacedOtherwise) {
  const NearFaultPulse returning;
  EXPECT_NEAR(closed_form_permanent_displacement(returning), 0.0, 1e-15);
  const NearFaultPulse displaced{.oscillation_ratio = 2.5, .phase = 0.5, .lead_in = 1.3 * s, .quiet_after = 1.3 * s};
  EXPECT_GT(std::abs(closed_form_permanent_displacement(displaced)), 0.02);
  for (const NearFaultPulse& pulse : {returning, displaced}) {
    const double coarse = permanent_displacement_error(pulse, 0.01 * s);
    const double fine = permanent_displacement_error(pulse, 0.005 * s);
    EXPECT_LT(fine, 3e-5);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
  }
}

TEST(NearFaultPulse, TakesTheParametersOfAScript) {
  const GroundMotion motion = near_fault_pulse({.pulse_period = 2 * s}).scaled_to_pga(0.4 * g);
  EXPECT_EQ(motion.name(), "near-fault pulse 2 s");
  EXPECT_DOUBLE_EQ(motion.peak_acceleration() / g, 0.4);
  ASSERT_FALSE(motion.notes().empty());
  EXPECT_EQ(motion.notes()[0],
            "Mavroeidis-Papageorgiou pulse: period 2 s, amplitude 0.8 m/s, oscillation ratio 2, phase 0.785398 rad");
}

TEST(NearFaultPulse, NamesTheParameterOutOfRange) {
  const auto refusal = [](const NearFaultPulse& pulse) {
    return message_of<InputError>([&] { (void)near_fault_pulse(pulse); });
  };
  EXPECT_EQ(
      refusal({.pulse_period = -1 * s}),
      "NearFaultPulse: pulse_period = -1 s is not allowed; it must be > 0 s and finite. Check its sign and its unit.");
  EXPECT_EQ(refusal({.amplitude = -1 * (m / s)}),
            "NearFaultPulse: amplitude = -1 m/s is not allowed; it must be > 0 m/s and finite. Use scaled_by(-1) to "
            "turn the direction of the motion.");
  EXPECT_EQ(refusal({.oscillation_ratio = 1.0}),
            "NearFaultPulse: oscillation_ratio = 1 is not allowed; it must be > 1 and <= 20. It is the length of the "
            "pulse over its period; observed pulses have 1 to 3.");
  EXPECT_EQ(refusal({.phase = 90.0}),
            "NearFaultPulse: phase = 90 rad is not allowed; it must be from -6.28319 rad to 6.28319 rad. Give it in "
            "radians.");
  EXPECT_EQ(refusal({.pulse_period = 1 * s, .time_step = 0.06 * s}),
            "NearFaultPulse: time_step = 0.06 s is not allowed; it must be > 0 s and <= 0.05 s. The period of the "
            "pulse needs at least 20 samples.");
  EXPECT_EQ(
      refusal({.lead_in = -1 * s}),
      "NearFaultPulse: lead_in = -1 s is not allowed; it must be from 0 s to 1000 s. Check its sign and its unit.");
  EXPECT_EQ(refusal({.quiet_after = 1e4 * s}),
            "NearFaultPulse: quiet_after = 10000 s is not allowed; it must be from 0 s to 1000 s. Check its sign and "
            "its unit.");
  EXPECT_EQ(refusal({.time_step = 1e-6 * s}),
            "NearFaultPulse: total duration / time_step = 2e+07 is not allowed; it must be < 1e7. Give a longer "
            "time_step or a shorter lead_in and quiet_after.");
}

}  // namespace
}  // namespace moat
