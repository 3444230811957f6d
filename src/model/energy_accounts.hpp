// The work done on elements, and the energy that they stored and dissipated.
#pragma once

#include <cstddef>

namespace moat {

/// Work, stored and dissipated energy of an element, J. Work is formed from forces and deformations, the stored energy
/// from the law's potential, the dissipated from the law's own dissipation: three independent numbers, so that their
/// difference is an error of the time integration and not zero by construction.
struct ElementEnergy {
  double work = 0.0;        ///< of the force on the deformation, by the WorkRule of every step
  double stored = 0.0;      ///< recoverable energy now less that at the start
  double dissipated = 0.0;  ///< integral of dissipation_rate, and the energy that changes of regime released
  bool hysteretic = false;  ///< dissipates by sliding, at any speed; else viscous
  double friction = 0.0;    ///< dissipated by friction in a contact, in addition

  /// Work that is neither stored nor dissipated.
  [[nodiscard]] double error() const { return work - stored - dissipated - friction; }
};

/// Sums over many elements, J.
struct EnergySums {
  double work = 0.0, stored = 0.0, error = 0.0;                                ///< sums of those of the elements
  double viscous = 0.0, hysteretic = 0.0, by_impact = 0.0, by_friction = 0.0;  ///< dissipated

  /// Adds those of one element.
  void add(bool is_contact, const ElementEnergy& energy) {
    work += energy.work;
    stored += energy.stored;
    error += energy.error();
    by_friction += energy.friction;
    (is_contact ? by_impact : energy.hysteretic ? hysteretic : viscous) += energy.dissipated;
  }
};

/// How the work of a step is formed.
enum class WorkRule {
  /// Mean force times change of deformation: with average acceleration an identity with the kinetic energy.
  mean_force,
  /// Lobatto's rule with four points on the interpolant of the deformation, of order six: for steps of higher order.
  quadrature,
};

}  // namespace moat
