// Bouc-Wen hysteresis of two components.
#pragma once

#include "materials/plan/planar_response.hpp"
#include "materials/saturating_slip.hpp"

namespace moat {

/// Bouc-Wen hysteresis of two components in its isotropic form, with n = 2 and beta = gamma = 1/2:
///
///     F = k2 d + Q z,   d_y z' = d' - z max(z.d', 0),   |z| <= 1
///
/// Park, Wen & Ang 1986, Random vibration of hysteretic systems under bi-directional ground motions. The force turns
/// with the path, for any directions of the axes. z follows a straight increment in closed form, and a curved one to
/// fourth order (materials/saturating_slip.hpp).
struct BiaxialBoucWen {
  static constexpr std::string_view name = "BiaxialBoucWen";

  /// Q > 0 N: the largest hysteretic force.
  Required<Force> characteristic_strength;
  /// d_y > 0 m: Q/d_y is the hysteretic stiffness at the origin.
  Required<Length> yield_displacement;
  /// k2 >= 0 N/m.
  Required<Stiffness> post_yield_stiffness;

  using State = SaturatingState;

  void check(const Check& check) const {
    check.positive("characteristic_strength", characteristic_strength);
    check.positive("yield_displacement", yield_displacement);
    check.not_negative("post_yield_stiffness", post_yield_stiffness);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"characteristic_strength", characteristic_strength.si(), "N"},
            {"yield_displacement", yield_displacement.si(), "m"},
            {"post_yield_stiffness", post_yield_stiffness.si(), "N/m"}};
  }

  PlanarResponse evaluate(const State& committed, PlanVector deformation, PlanVector rate, double interval,
                          State& trial) const {
    const SaturatingSlip slip{SaturatingSlip::Begins::from_the_start, yield_displacement.si()};
    return saturating_response(slip, characteristic_strength.si(), post_yield_stiffness.si(), committed, deformation,
                               rate, interval, trial);
  }
  double stored_energy(const State& committed, PlanVector deformation) const {
    return 0.5 * post_yield_stiffness.si() * dot(deformation, deformation) +
           0.5 * characteristic_strength.si() * yield_displacement.si() * dot(committed.z, committed.z);
  }
  double dissipated_energy(const State& from, const State& to) const {
    return characteristic_strength.si() * yield_displacement.si() * (to.dissipated - from.dissipated);
  }
  double linear_stiffness(StiffnessStage stage) const {
    const double hysteretic =
        stage == StiffnessStage::initial ? characteristic_strength.si() / yield_displacement.si() : 0.0;
    return post_yield_stiffness.si() + hysteretic;
  }
};

}  // namespace moat
