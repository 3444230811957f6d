// A linear bearing of two components.
#pragma once

#include "materials/plan/planar_response.hpp"

namespace moat {

/// A linear spring, alike in all directions: a bearing of natural rubber, or the equivalent linear bearing of a code.
/// Its damping is that of dashpots beside it, PlanSpring<Viscous>.
///
///     F = k d
struct BiaxialLinear {
  static constexpr std::string_view name = "BiaxialLinear";

  /// k > 0 N/m.
  Required<Stiffness> stiffness;
  struct State {
    friend bool operator==(const State&, const State&) = default;
  };

  void check(const Check& check) const { check.positive("stiffness", stiffness); }
  [[nodiscard]] std::vector<Parameter> parameters() const { return {{"stiffness", stiffness.si(), "N/m"}}; }

  PlanarResponse evaluate(const State&, PlanVector deformation, PlanVector rate, double, State&) const {
    return {.force = stiffness.si() * deformation,
            .stiffness = PlanMatrix::diagonal(stiffness.si()),
            .force_rate = stiffness.si() * rate};
  }
  double stored_energy(const State&, PlanVector deformation) const {
    return 0.5 * stiffness.si() * dot(deformation, deformation);
  }
  double dissipated_energy(const State&, const State&) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return stiffness.si(); }
};

}  // namespace moat
