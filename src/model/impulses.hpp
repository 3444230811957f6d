// Integrals of forces over a step, and how schemes form them.
#pragma once

#include "base/vector.hpp"

namespace moat {

/// How a scheme forms the integral of a force f over a step of h s, of the forces and their rates at its ends:
///
///     h (of_start f0 + of_end f1) + h^2 (of_start_rate f0' + of_end_rate f1')
struct ImpulseRule {
  double of_start = 0.0, of_end = 0.0, of_start_rate = 0.0, of_end_rate = 0.0;  ///< without unit
};

/// The rules of a scheme.
struct ImpulseRules {
  ImpulseRule of_velocity;            ///< of the integral of f dt: the change of momentum
  ImpulseRule of_evaluated_velocity;  ///< the same for the velocity that forces are evaluated with
  ImpulseRule of_displacement;        ///< of the integral of (1 - t/h) f dt: mass times displacement, over h
};

/// The part that a scheme leaves out of the integrals of forces over a step, N s, by degree of freedom; the last entry
/// is that of the ground.
struct MissedImpulses {
  Vector of_velocity, of_evaluated_velocity, of_displacement;  ///< as in ImpulseRules

  /// Sets the impulses of so many degrees of freedom to zero.
  void clear(Eigen::Index count) {
    for (Vector* values : {&of_velocity, &of_evaluated_velocity, &of_displacement}) values->setZero(count + 1);
  }
};

/// A force over a step: values and rates at its ends, and its integrals.
struct ForceOverStep {
  double start = 0.0, start_rate = 0.0, end = 0.0, end_rate = 0.0;  ///< N, N/s
  double impulse = 0.0;                                             ///< integral of f dt, N s
  double falling = 0.0;                                             ///< integral of (1 - t/h) f dt, N s

  /// The part that a rule leaves out of an integral over a step of h s.
  [[nodiscard]] double missed(double integral, const ImpulseRule& rule, double h) const {
    return integral - h * (rule.of_start * start + rule.of_end * end) -
           h * h * (rule.of_start_rate * start_rate + rule.of_end_rate * end_rate);
  }
};

}  // namespace moat
