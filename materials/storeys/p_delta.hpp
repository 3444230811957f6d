// The weight above a storey that leans.
#pragma once

#include "materials/response.hpp"

namespace moat {

/// P-delta: the weight above a storey, on leaning columns, pushes it further.
///
///     F = -(P/h) d,    beside the storey's own force
///
/// The storey must be stiffer: its period grows by 1/sqrt(1 - P/(k h)). Small drifts only (d/h below 0.1). Stored
/// energy -P d^2/(2 h): the height that the weight loses.
struct PDelta {
  static constexpr std::string_view name = "PDelta";
  static constexpr std::string_view formula = "F = -(P/h) d";
  static constexpr std::string_view assumption = "Drifts below a tenth of the height of the storey.";

  /// P > 0 N: of everything above the storey.
  Required<Force> weight;
  /// h > 0 m.
  Required<Length> height;

  using State = NoState;
  static constexpr bool linear_within_regimes = true;

  static PDelta typical() {
    using namespace units;
    return {.weight = 25 * MN, .height = 3.5 * m};
  }

  void check(const Check& check) const {
    check.positive("weight", weight);
    check.positive("height", height);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"weight", weight.si(), "N"}, {"height", height.si(), "m"}};
  }
  [[nodiscard]] double stiffness() const { return -weight.si() / height.si(); }  ///< N/m, negative

  Response evaluate(const State&, double deformation, double, State&) const {
    return {stiffness() * deformation, stiffness(), 0.0};
  }
  double stored_energy(const State&, double deformation) const { return 0.5 * stiffness() * deformation * deformation; }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return stiffness(); }
};

}  // namespace moat
