// Energy of the friction of a corner along an edge.
#pragma once

#include <algorithm>

#include "elements/contact/corner_grip.hpp"
#include "model/element_block.hpp"

namespace moat {

/// Energy that went into the friction of one corner since its account started, J.
struct CornerGripEnergy {
  double work = 0.0;             ///< of the friction along the path
  double friction = 0.0;         ///< lost by sliding
  double stored_at_start = 0.0;  ///< in the tangential spring when the account started

  /// Adds a step of `step` s between these grips; 0: the same instant again, after a change of the normal force.
  void add_step(const CornerGrip& start, const CornerGrip& now, ContactFriction law, double step, WorkRule rule) {
    if (step == 0.0) {
      // Where the normal force jumped down, the grip gives up its energy.
      friction += std::max(start.stored(law) - now.stored(law), 0.0);
      return;
    }
    if (start.force == 0.0 && now.force == 0.0) return;
    const double mean = 0.5 * (start.force + now.force);
    friction += mean * (now.slip - start.slip);
    work += mean * (now.path - start.path);
    if (rule == WorkRule::mean_force) return;
    // The power is smooth but for kinks: the trapezoidal rule with its correction by the rates at the ends.
    const auto power_rate = [](const CornerGrip& grip) {
      return grip.force_rate * grip.rate + grip.force * grip.second_rate;
    };
    work += 0.5 * step * (start.force * start.rate + now.force * now.rate) - mean * (now.path - start.path) +
            step * step / 12.0 * (power_rate(start) - power_rate(now));
  }
};

}  // namespace moat
