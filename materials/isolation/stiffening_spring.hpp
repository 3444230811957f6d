// A spring that acts beyond a deformation.
#pragma once

#include <cmath>

#include "materials/response.hpp"

namespace moat {

/// F = k_s (|d| - d_s) sgn d beyond |d| = d_s, else 0: rubber that stiffens at large strain, beside a bearing.
///
/// Its regimes (inside, beyond to either side) are located. Tension positive. Rubber stiffens from a shear strain
/// of 1.5 to 2; k_s is then once to three times the stiffness after yield.
struct StiffeningSpring {
  static constexpr std::string_view name = "StiffeningSpring";
  static constexpr std::string_view formula = "F = k_s (abs(d) - d_s) sgn(d) beyond d_s";

  /// k_s > 0 N/m.
  Required<Stiffness> stiffness;
  /// d_s > 0 m.
  Required<Length> start;

  struct State {
    int side = 0;  ///< -1, +1: beyond; 0: inside
    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr bool linear_within_regimes = true;
  /// m: the change of regime must not be switched by round-off.
  static constexpr double threshold = 1e-10;

  static StiffeningSpring typical() {
    using namespace units;
    return {.stiffness = 20 * MN / m, .start = 20 * cm};
  }

  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    check.positive("start", start);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"stiffness", stiffness.si(), "N/m"}, {"start", start.si(), "m"}};
  }
  Response evaluate(const State& committed, double deformation, double, State& trial) const {
    trial = committed;
    if (committed.side == 0) return {};
    return {stiffness.si() * (deformation - committed.side * start.si()), stiffness.si(), 0.0};
  }
  double stored_energy(const State& committed, double deformation) const {
    if (committed.side == 0) return 0.0;
    const double beyond = deformation - committed.side * start.si();
    return 0.5 * stiffness.si() * beyond * beyond;
  }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return 0.0; }

  double regime_margin(const State& committed, double deformation, double) const {
    return threshold +
           (committed.side == 0 ? start.si() - std::abs(deformation) : committed.side * deformation - start.si());
  }
  State next_regime(const State& committed, double deformation, double) const {
    return {committed.side != 0 ? 0 : deformation > 0.0 ? 1 : -1};
  }
};

}  // namespace moat
