// Flat slider with a restoring spring.
#pragma once

#include "materials/carried_weight.hpp"
#include "materials/sliding_under_weight.hpp"

namespace moat {

/// Flat slider: friction without gravity's restoring force, with springs beside it or without.
///
///     F = k_r d + q,    |q| <= mu(|v|) W,    elastic with mu W/u_y before it slides
///
/// With springs it is the EradiQuake type of bearing; without them it stays where it stops. The weight is
/// constant, unless the building has AxialForces.
struct FlatSlider {
  static constexpr std::string_view name = "FlatSlider";
  static constexpr std::string_view formula = "F = k_r d + q, abs(q) <= mu W; stick and slip located";

  Required<Friction> friction;  ///< Coefficient, or a model of friction.
  /// k_r >= 0 N/m.
  Stiffness restoring_stiffness{};
  /// u_y > 0 m.
  Length yield_displacement = 1.0 * units::mm;
  /// W > 0 N; that of the building if left out.
  Force weight{};

  static FlatSlider typical() {
    using namespace units;
    return {.friction = 0.06, .restoring_stiffness = 6 * MN / m};
  }

  void check(const Check& check) const {
    friction.value().check(check);
    check.not_negative("restoring_stiffness", restoring_stiffness);
    check.positive("yield_displacement", yield_displacement);
    check.not_negative("weight", weight);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    std::vector<Parameter> list = friction.value().parameters();
    list.push_back({"restoring_stiffness", restoring_stiffness.si(), "N/m"});
    list.push_back({"yield_displacement", yield_displacement.si(), "m"});
    return list;
  }
  /// The law under a weight that changes; `load` > 0 N is that at rest.
  [[nodiscard]] SlidingUnderWeight under_changing_weight(Force load) const {
    const double normal = load.si();
    return {.restoring_stiffness = restoring_stiffness.si(),
            .elastic_stiffness = friction.value().fast(normal) * normal / yield_displacement.si(),
            .static_weight = normal,
            .friction = friction};
  }
  [[nodiscard]] SlidingIsolator carrying(Force load) const {
    const double normal = load.si();
    return {.restoring_stiffness = restoring_stiffness.si(),
            .elastic_stiffness = friction.value().fast(normal) * normal / yield_displacement.si(),
            .normal_force = normal,
            .friction = friction};
  }
};

}  // namespace moat
