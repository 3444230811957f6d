// Bilinear hysteresis with kinematic hardening.
#pragma once

#include <cmath>

#include "materials/response.hpp"

namespace moat {

/// Bilinear hysteresis with kinematic hardening: the usual model of a lead-rubber bearing.
///
///         F ^            ________ post_yield_stiffness
///       F_y |......_____/
///           |     /:    /
///           |    / :   /       An elastic spring k2 = post_yield_stiffness in parallel with a
///           |   /  :  /        spring k1 - k2 that slides at (k1 - k2) d_y, where
///     ------+--/---:-/-----> d k1 = F_y / d_y is the initial stiffness:
///           | d_y   /          F = k2 d + (k1 - k2) (d - s),  |d - s| <= d_y,  s = slip.
///
/// Unloading is elastic with k1 over a range of 2 d_y. Tension positive.
/// The energy dissipated in a full cycle of amplitude D > d_y is 4 (k1 - k2) d_y (D - d_y).
///
/// Its regimes: elastic until |d - s| = d_y; sliding in one direction until the rate turns. The force is linear between
/// these located instants, so that no step smears a corner.
struct Bilinear {
  static constexpr std::string_view name = "Bilinear";

  /// F_y > 0 N: force at first yield.
  Required<Force> yield_force;
  /// d_y > 0 m: deformation at first yield.
  Required<Length> yield_displacement;
  /// 0 <= k2 < F_y / d_y, N/m.
  Required<Stiffness> post_yield_stiffness;

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

  void check(const Check& check) const {
    check.positive("yield_force", yield_force);
    check.positive("yield_displacement", yield_displacement);
    check.not_negative("post_yield_stiffness", post_yield_stiffness);
    if (post_yield_stiffness.si() < initial_stiffness()) return;
    check.that(
        false, "post_yield_stiffness", post_yield_stiffness.si(), "N/m",
        "below the initial stiffness yield_force / yield_displacement = " + to_text(initial_stiffness()) + " N/m",
        "Check the exponents of the three parameters.");
  }

  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"yield_force", yield_force.si(), "N"},
            {"yield_displacement", yield_displacement.si(), "m"},
            {"post_yield_stiffness", post_yield_stiffness.si(), "N/m"}};
  }

  [[nodiscard]] double initial_stiffness() const { return yield_force.si() / yield_displacement.si(); }  ///< N/m

  Response evaluate(const State& committed, double deformation, double, State& trial) const {
    const double post_yield = post_yield_stiffness.si(), sliding = initial_stiffness() - post_yield;
    trial = committed;
    if (committed.direction == 0) {
      const double stretch = deformation - committed.slip;
      return {post_yield * deformation + sliding * stretch, post_yield + sliding, 0.0};
    }
    const double kept = committed.direction * yield_displacement.si();
    trial.slip = deformation - kept;
    return {post_yield * deformation + sliding * kept, post_yield, 0.0};
  }
  double stored_energy(const State& committed, double deformation) const {
    const double post_yield = post_yield_stiffness.si();
    const double kept =
        committed.direction == 0 ? deformation - committed.slip : committed.direction * yield_displacement.si();
    return 0.5 * post_yield * deformation * deformation + 0.5 * (initial_stiffness() - post_yield) * kept * kept;
  }
  double dissipation_rate(const State& committed, double, double rate) const {
    if (committed.direction * rate <= 0.0) return 0.0;
    return (initial_stiffness() - post_yield_stiffness.si()) * yield_displacement.si() * std::abs(rate);
  }
  /// Exact for any path from one state to the other along which the slip grows or falls only: (k1 - k2) d_y |ds|.
  double dissipated_energy(const State& from, const State& to) const {
    return (initial_stiffness() - post_yield_stiffness.si()) * yield_displacement.si() * std::abs(to.slip - from.slip);
  }
  double linear_stiffness(StiffnessStage stage) const {
    return stage == StiffnessStage::initial ? initial_stiffness() : post_yield_stiffness.si();
  }

  double regime_margin(const State& committed, double deformation, double rate) const {
    if (committed.direction != 0) return committed.direction * rate * time_of_rate;
    return yield_displacement.si() * (1.0 + threshold) - std::abs(deformation - committed.slip);
  }
  State next_regime(const State& committed, double deformation, double) const {
    if (committed.direction != 0) return {deformation - committed.direction * yield_displacement.si(), 0};
    const int direction = deformation > committed.slip ? 1 : -1;
    return {deformation - direction * yield_displacement.si(), direction};
  }
};

}  // namespace moat
