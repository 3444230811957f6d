// Bilinear hysteresis whose yield and unloading are located.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "materials/bilinear.hpp"

namespace moat {

/// The force of Bilinear, with its corners at located instants: between them it is linear, so that no step
/// smears a corner. Costs two or three more solves per corner.
///
/// Regimes: elastic until |d - s| = d_y; sliding in one direction until the rate turns.
struct LocatedBilinear {
  static constexpr std::string_view name = "LocatedBilinear";

  Bilinear law;  ///< Whose corners are located.

  struct State {
    double slip = 0.0;  ///< m
    int direction = 0;  ///< of sliding: -1, +1; 0: elastic

    friend bool operator==(const State&, const State&) = default;
  };

  static constexpr bool linear_within_regimes = true;

  /// A rate enters the regime margin as the distance in this time, s, which is of the order of 1/omega of an isolated
  /// building. While the bearing slides, the margin is its rate of sliding times this time.
  static constexpr double time_of_rate = 1.0;

  /// Yield is noticed this much beyond d_y, relative: the end of unloading must not switch it by round-off.
  static constexpr double threshold = 1e-9;

  [[nodiscard]] std::vector<Parameter> parameters() const { return law.parameters(); }
  Response evaluate(const State& committed, double deformation, double, State& trial) const {
    const double post_yield = law.post_yield_stiffness.si();
    const double sliding = law.initial_stiffness() - post_yield;
    trial = committed;
    if (committed.direction == 0) {
      const double stretch = deformation - committed.slip;
      return {post_yield * deformation + sliding * stretch, post_yield + sliding, 0.0};
    }
    const double kept = committed.direction * law.yield_displacement.si();
    trial.slip = deformation - kept;
    return {post_yield * deformation + sliding * kept, post_yield, 0.0};
  }
  double stored_energy(const State& committed, double deformation) const {
    const double post_yield = law.post_yield_stiffness.si();
    const double kept =
        committed.direction == 0 ? deformation - committed.slip : committed.direction * law.yield_displacement.si();
    return 0.5 * post_yield * deformation * deformation + 0.5 * (law.initial_stiffness() - post_yield) * kept * kept;
  }
  double dissipation_rate(const State& committed, double, double rate) const {
    if (committed.direction * rate <= 0.0) return 0.0;
    return (law.initial_stiffness() - law.post_yield_stiffness.si()) * law.yield_displacement.si() * std::abs(rate);
  }
  double dissipated_energy(const State& from, const State& to) const {
    return law.dissipated_energy({from.slip}, {to.slip});
  }
  double linear_stiffness(StiffnessStage stage) const { return law.linear_stiffness(stage); }

  double regime_margin(const State& committed, double deformation, double rate) const {
    if (committed.direction != 0) return committed.direction * rate * time_of_rate;
    return law.yield_displacement.si() * (1.0 + threshold) - std::abs(deformation - committed.slip);
  }
  State next_regime(const State& committed, double deformation, double) const {
    if (committed.direction != 0) return {deformation - committed.direction * law.yield_displacement.si(), 0};
    const int direction = deformation > committed.slip ? 1 : -1;
    return {deformation - direction * law.yield_displacement.si(), direction};
  }
};

}  // namespace moat
