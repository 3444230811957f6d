// A storey that yields.
#pragma once

#include <array>
#include <cmath>

#include "materials/bilinear.hpp"
#include "materials/response.hpp"

namespace moat {

/// A storey whose columns yield: bilinear with kinematic hardening, yield and unloading located (bilinear.hpp).
///
///     F = k d up to F_y, then with hardening_ratio k;    unloading with k over a range of 2 d_y,    d_y = F_y/k
///
/// Reports `ductility`, d/d_y, and `residual_drift` [m], the drift that would stay without shear.
struct YieldingStorey {
  static constexpr std::string_view name = "YieldingStorey";
  static constexpr std::string_view formula = "k to F_y, then hardening_ratio k; corners located";

  /// k > 0 N/m.
  Required<Stiffness> stiffness;
  /// F_y > 0 N.
  Required<Force> yield_force;
  /// 0 <= ratio < 1.
  double hardening_ratio = 0.05;

  using State = Bilinear::State;
  static constexpr bool linear_within_regimes = true;
  static constexpr std::array<ReportedQuantity, 2> quantities{
      {{.name = "ductility", .unit = "1"}, {.name = "residual_drift", .unit = "m"}}};

  /// A concrete frame of 500 t floors, with a yield drift of 0.6 cm.
  static YieldingStorey typical() {
    using namespace units;
    return {.stiffness = 1 * GN / m, .yield_force = 6 * MN};
  }

  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    check.positive("yield_force", yield_force);
    check.that(hardening_ratio >= 0.0 && hardening_ratio < 1.0, "hardening_ratio", hardening_ratio, "1", ">= 0 and < 1",
               "0.02 to 0.1 is usual.");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"stiffness", stiffness.si(), "N/m"},
            {"yield_force", yield_force.si(), "N"},
            {"hardening_ratio", hardening_ratio, "1"}};
  }

  Response evaluate(const State& committed, double deformation, double rate, State& trial) const {
    return law().evaluate(committed, deformation, rate, trial);
  }
  double stored_energy(const State& committed, double deformation) const {
    return law().stored_energy(committed, deformation);
  }
  double dissipation_rate(const State& committed, double deformation, double rate) const {
    return law().dissipation_rate(committed, deformation, rate);
  }
  double dissipated_energy(const State& from, const State& to) const { return law().dissipated_energy(from, to); }
  double linear_stiffness(StiffnessStage stage) const { return law().linear_stiffness(stage); }
  double regime_margin(const State& committed, double deformation, double rate) const {
    return law().regime_margin(committed, deformation, rate);
  }
  State next_regime(const State& committed, double deformation, double rate) const {
    return law().next_regime(committed, deformation, rate);
  }
  ReportedValue quantity(std::size_t index, const State& state, double deformation, double rate, double) const {
    const double yield_drift = yield_force.si() / stiffness.si();
    if (index == 0) return {deformation / yield_drift, rate / yield_drift};
    // Without force k2 d + (k1 - k2)(d - s) = 0.
    return {(1.0 - hardening_ratio) * state.slip, state.direction == 0 ? 0.0 : (1.0 - hardening_ratio) * rate};
  }

 private:
  [[nodiscard]] Bilinear law() const {
    return {.yield_force = yield_force,
            .yield_displacement = yield_force.value() / stiffness.value(),
            .post_yield_stiffness = hardening_ratio * stiffness.value()};
  }
};

}  // namespace moat
