// Bilinear hysteresis with kinematic hardening.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
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

    friend bool operator==(const State&, const State&) = default;
  };

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
    const double post_yield = post_yield_stiffness.si();
    const double sliding = initial_stiffness() - post_yield;
    const double limit = yield_displacement.si();
    const double stretch = deformation - committed.slip;
    const bool slides = std::abs(stretch) > limit;
    const double kept = slides ? std::copysign(limit, stretch) : stretch;
    trial.slip = slides ? deformation - kept : committed.slip;
    return {post_yield * deformation + sliding * kept, slides ? post_yield : post_yield + sliding, 0.0};
  }
  double stored_energy(const State& committed, double deformation) const {
    const double post_yield = post_yield_stiffness.si();
    const double kept = std::clamp(deformation - committed.slip, -yield_displacement.si(), yield_displacement.si());
    return 0.5 * post_yield * deformation * deformation + 0.5 * (initial_stiffness() - post_yield) * kept * kept;
  }
  double dissipation_rate(const State& committed, double deformation, double rate) const {
    const double stretch = deformation - committed.slip;
    const double limit = yield_displacement.si();
    const bool slides = std::abs(stretch) >= limit * (1.0 - 1e-12) && stretch * rate > 0.0;
    return slides ? (initial_stiffness() - post_yield_stiffness.si()) * limit * std::abs(rate) : 0.0;
  }
  /// Exact for any path from one state to the other along which the slip grows or falls only: (k1 - k2) d_y |ds|.
  double dissipated_energy(const State& from, const State& to) const {
    return (initial_stiffness() - post_yield_stiffness.si()) * yield_displacement.si() * std::abs(to.slip - from.slip);
  }
  double linear_stiffness(StiffnessStage stage) const {
    return stage == StiffnessStage::initial ? initial_stiffness() : post_yield_stiffness.si();
  }
};

}  // namespace moat
