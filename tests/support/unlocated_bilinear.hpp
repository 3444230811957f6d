// Bilinear hysteresis as a script may write it: its corners are not located.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/response.hpp"

namespace moat::testing {

/// The force of Bilinear (materials/bilinear.hpp) by return mapping, without regimes: each evaluation sees the ends of
/// an increment alone. Plain numbers, in N and m.
struct UnlocatedBilinear {
  double yield_force, yield_displacement, post_yield_stiffness;

  struct State {
    double slip = 0.0;  ///< m
  };

  [[nodiscard]] double sliding_stiffness() const { return yield_force / yield_displacement - post_yield_stiffness; }

  Response evaluate(const State& committed, double deformation, double, State& trial) const {
    const double stretch = deformation - committed.slip;
    const bool slides = std::abs(stretch) > yield_displacement;
    const double kept = slides ? std::copysign(yield_displacement, stretch) : stretch;
    trial.slip = slides ? deformation - kept : committed.slip;
    return {post_yield_stiffness * deformation + sliding_stiffness() * kept,
            post_yield_stiffness + (slides ? 0.0 : sliding_stiffness()), 0.0};
  }
  double stored_energy(const State& committed, double deformation) const {
    const double kept = std::clamp(deformation - committed.slip, -yield_displacement, yield_displacement);
    return 0.5 * post_yield_stiffness * deformation * deformation + 0.5 * sliding_stiffness() * kept * kept;
  }
  double dissipation_rate(const State& committed, double deformation, double rate) const {
    const double stretch = deformation - committed.slip;
    const bool slides = std::abs(stretch) >= yield_displacement * (1.0 - 1e-12) && stretch * rate > 0.0;
    return slides ? sliding_stiffness() * yield_displacement * std::abs(rate) : 0.0;
  }
  double dissipated_energy(const State& from, const State& to) const {
    return sliding_stiffness() * yield_displacement * std::abs(to.slip - from.slip);
  }
  double linear_stiffness(StiffnessStage stage) const {
    return post_yield_stiffness + (stage == StiffnessStage::initial ? sliding_stiffness() : 0.0);
  }
};

}  // namespace moat::testing
