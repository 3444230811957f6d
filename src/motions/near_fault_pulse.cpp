#include "motions/near_fault_pulse.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/check.hpp"

namespace moat {
namespace {

using std::numbers::pi;

void validate(const NearFaultPulse& pulse) {
  const Check check{"NearFaultPulse", ""};
  check.positive("pulse_period", pulse.pulse_period);
  check.positive("amplitude", pulse.amplitude, "Use scaled_by(-1) to turn the direction of the motion.");
  check.above_up_to("oscillation_ratio", pulse.oscillation_ratio, 1.0, 20.0, "1",
                    "It is the length of the pulse over its period; observed pulses have 1 to 3.");
  check.between("phase", pulse.phase, -2.0 * pi, 2.0 * pi, "rad", "Give it in radians.");
  check.above_up_to("time_step", pulse.time_step.si(), 0.0, pulse.pulse_period.si() / 20.0, "s",
                    "The period of the pulse needs at least 20 samples.");
  constexpr double longest_rest = 1000.0;
  check.between("lead_in", pulse.lead_in.si(), 0.0, longest_rest, "s");
  check.between("quiet_after", pulse.quiet_after.si(), 0.0, longest_rest, "s");
}

}  // namespace

GroundMotion near_fault_pulse(const NearFaultPulse& parameters) {
  validate(parameters);
  const double frequency = 2.0 * pi / parameters.pulse_period.si();
  const double gamma = parameters.oscillation_ratio;
  const double half_length = gamma * parameters.pulse_period.si() / 2.0;
  const double middle = parameters.lead_in.si() + half_length;
  const double time_step = parameters.time_step.si();
  const double total = middle + half_length + parameters.quiet_after.si();

  // Round-off in the sum must not add a sample after an end that falls on the grid.
  const double steps_needed = std::ceil(total / time_step * (1.0 - 1e-12));
  Check{"NearFaultPulse", ""}.that(steps_needed < 1e7, "total duration / time_step", steps_needed, "1", "< 1e7",
                                   "Give a longer time_step or a shorter lead_in and quiet_after.");
  const auto steps = static_cast<std::size_t>(steps_needed);
  std::vector<double> samples(steps + 1, 0.0);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double time = static_cast<double>(i) * time_step - middle;
    if (std::abs(time) >= half_length) continue;
    const double envelope = frequency * time / gamma;
    const double carrier = frequency * time + parameters.phase;
    samples[i] = -parameters.amplitude.si() * frequency / (2.0 * gamma) *
                 (std::sin(envelope) * std::cos(carrier) + gamma * std::sin(carrier) * (1.0 + std::cos(envelope)));
  }
  const std::string note = "Mavroeidis-Papageorgiou pulse: period " + to_text(parameters.pulse_period.si()) +
                           " s, amplitude " + to_text(parameters.amplitude.si()) + " m/s, oscillation ratio " +
                           to_text(gamma) + ", phase " + to_text(parameters.phase) + " rad";
  return GroundMotion{
      "near-fault pulse " + to_text(parameters.pulse_period.si()) + " s", time_step, std::move(samples), {note}};
}

}  // namespace moat
