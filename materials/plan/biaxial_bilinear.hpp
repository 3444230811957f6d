// Bilinear hysteresis of two components.
#pragma once

#include "materials/bilinear.hpp"
#include "materials/plan/planar_response.hpp"
#include "materials/saturating_slip.hpp"

namespace moat {

/// Bilinear hysteresis whose yield surface is a circle: a lead-rubber bearing in plan.
///
///     F = k2 d + Q z,   z' = d'/d_y inside |z| < 1, and on |z| = 1 with perfect plasticity (slip along z)
///
/// with k1 = F_y/d_y the initial stiffness, k2 = post_yield_stiffness and Q = (k1 - k2) d_y. Along a line it is
/// `Bilinear`. The update is exact for straight increments (Krieg & Krieg 1977, Accuracies of numerical solution
/// methods for the elastic-perfectly plastic model), and so is the dissipation; for curved ones it is of fourth order
/// (materials/saturating_slip.hpp).
struct BiaxialBilinear {
  static constexpr std::string_view name = "BiaxialBilinear";

  /// F_y > 0 N: force at first yield.
  Required<Force> yield_force;
  /// d_y > 0 m: deformation at first yield.
  Required<Length> yield_displacement;
  /// 0 <= k2 < F_y / d_y, N/m.
  Required<Stiffness> post_yield_stiffness;

  using State = SaturatingState;

  void check(const Check& check) const { Bilinear{yield_force, yield_displacement, post_yield_stiffness}.check(check); }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"yield_force", yield_force.si(), "N"},
            {"yield_displacement", yield_displacement.si(), "m"},
            {"post_yield_stiffness", post_yield_stiffness.si(), "N/m"}};
  }
  /// Q, N.
  [[nodiscard]] double strength() const {
    return yield_force.si() - post_yield_stiffness.si() * yield_displacement.si();
  }

  PlanarResponse evaluate(const State& committed, PlanVector deformation, PlanVector rate, double interval,
                          State& trial) const {
    const SaturatingSlip slip{SaturatingSlip::Begins::on_the_circle, yield_displacement.si()};
    return saturating_response(slip, strength(), post_yield_stiffness.si(), committed, deformation, rate, interval,
                               trial);
  }
  double stored_energy(const State& committed, PlanVector deformation) const {
    return 0.5 * post_yield_stiffness.si() * dot(deformation, deformation) +
           0.5 * strength() * yield_displacement.si() * dot(committed.z, committed.z);
  }
  double dissipated_energy(const State& from, const State& to) const {
    return strength() * yield_displacement.si() * (to.dissipated - from.dissipated);
  }
  double linear_stiffness(StiffnessStage stage) const {
    return stage == StiffnessStage::initial ? yield_force.si() / yield_displacement.si() : post_yield_stiffness.si();
  }
};

}  // namespace moat
