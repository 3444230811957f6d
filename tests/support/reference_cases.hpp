// Small problems with closed forms, for tests of the independent reference.
#pragma once

#include <stdexcept>
#include <string>

#include "reference_history.hpp"

namespace moat::testing {

struct Oscillator {
  double mass = 1e5;           ///< kg
  double frequency = 0.0;      ///< 1/s; 0: no spring
  double damping_ratio = 0.0;  ///< of critical
  double displacement = 0.0, velocity = 0.0;
};

/// A ground that does not move, with samples so far apart that they do not shorten a step.
inline PlainMotion still() { return {2.0, {0.0, 0.0}}; }

/// The node "mass" on the spring "spring" for two seconds on still ground.
inline PlainModel oscillator(const Oscillator& of) {
  PlainModel model;
  model.nodes = {{"mass", of.mass, of.displacement, of.velocity}};
  if (of.frequency > 0.0)
    model.springs = {
        {"spring", PlainSpring::Kind::storey, plain_ground, 0, of.mass * of.frequency * of.frequency, 0.0}};
  if (of.damping_ratio > 0.0)
    model.dashpots = {{"dashpot", plain_ground, 0, 2.0 * of.damping_ratio * of.mass * of.frequency}};
  model.motion = still();
  model.end = 2.0;
  return model;
}

/// The free "mass" flies to the right into the gap "wall" of 10 cm before the ground.
inline PlainModel flight(double mass, double speed, const PlainLaw& law) {
  PlainModel model = oscillator({.mass = mass, .velocity = speed});
  model.gaps = {{"wall", "wall", {0, plain_ground, 0.0}, {}, 0.1, law}};
  return model;
}

inline ReferencePeak peak_of(const ReferenceResult& result, const std::string& quantity, const std::string& where) {
  for (const ReferencePeak& peak : result.peaks)
    if (peak.quantity == quantity && peak.where == where) return peak;
  throw std::invalid_argument{"no peak of " + quantity + " at " + where};
}

}  // namespace moat::testing
