// Coulomb friction of a corner along an edge.
#pragma once

#include <algorithm>
#include <limits>

#include "base/hermite.hpp"
#include "elements/block/regime_search.hpp"

namespace moat {

/// Coulomb friction of a contact.
struct ContactFriction {
  double coefficient = 0.0;           ///< mu, 0 to 1; 0 is no friction
  double tangential_stiffness = 0.0;  ///< k_t > 0 N/m
};

/// A corner that moves by u_t along an edge under the normal force F_n. By return mapping, with the slip s as history:
///
///     F_t = k_t (u_t - s),  |F_t| <= mu F_n,  s follows where it must;  without contact s = u_t
///
/// A corner that slides along t has s = u_t - mu F_n/k_t =: g, and it sticks from the instant on where g is largest: s
/// is the largest of its value before and of g inside the step, where g is the parabola through its value and rate at
/// the start and its value at the end. With the value at the end alone the corner would stick from the start of a step
/// in which it still slides, and every sticking would begin with an error of second order that stays until it ends.
struct CornerGrip {
  double path = 0.0, rate = 0.0, second_rate = 0.0;  ///< u_t, m, and its rates
  double slip = 0.0;                                 ///< s, m
  double force = 0.0, force_rate = 0.0;              ///< F_t, N, N/s
  double limit = 0.0, limit_rate = 0.0;              ///< mu F_n, N, N/s
  double sense = 0.0;                                ///< of sliding in the step: -1 or 1; 0 where it sticks throughout
  double follows = 0.0;                              ///< dF_t/d(sense limit), 0 to 1: 1 where it slides at the end

  /// Whether there is friction now.
  [[nodiscard]] bool holds() const { return limit > 0.0; }
  /// Whether the corner slides at the end of the step.
  [[nodiscard]] bool slides() const { return follows == 1.0; }
  /// dF_t/du_t, N/m.
  [[nodiscard]] double stiffness(ContactFriction friction) const {
    return holds() ? (1.0 - follows) * friction.tangential_stiffness : 0.0;
  }
  /// J.
  [[nodiscard]] double stored(ContactFriction friction) const {
    return force == 0.0 ? 0.0 : 0.5 * force * force / friction.tangential_stiffness;
  }

  /// The friction at this path and rate under a normal force, N, `step` s after `start`.
  void follow(const CornerGrip& start, double step, ContactFriction friction, double normal_force) {
    limit = friction.coefficient * std::max(normal_force, 0.0);
    sense = follows = force = 0.0;
    slip = path;
    if (!holds()) return;
    slip = start.slip;
    for (const double way : {1.0, -1.0}) slide(start, step, friction, way);
    force = friction.tangential_stiffness * (path - slip);
    // It slid both ways.
    if (const double way = force > 0.0 ? 1.0 : -1.0; way * force > limit) {
      slip = path - way * limit / friction.tangential_stiffness;
      sense = way;
      follows = 1.0;
    }
    if (slides()) force = sense * limit;
  }
  /// After follow(): the rates of forces, from that of the normal force, N/s.
  void find_rates(ContactFriction friction, double normal_force_rate, double acceleration) {
    second_rate = acceleration;
    limit_rate = holds() ? friction.coefficient * normal_force_rate : 0.0;
    force_rate = slides() ? sense * limit_rate : holds() ? friction.tangential_stiffness * rate : 0.0;
  }

  /// Whether it began to slide after `start`, also the other way. Where it ends to slide its force has no corner.
  [[nodiscard]] bool begins_to_slide(const CornerGrip& start) const {
    return sense != 0.0 && start.holds() && !(start.slides() && start.sense == sense);
  }
  /// Where between `start`, `step` s before, and now it began to slide, as a fraction of the step; NaN if it did not.
  [[nodiscard]] double slide_begin(const CornerGrip& start, double step, ContactFriction friction) const {
    if (step <= 0.0 || !begins_to_slide(start)) return std::numeric_limits<double>::quiet_NaN();
    const double flexibility = 1.0 / friction.tangential_stiffness;
    const HermiteCubic reach{sense * start.path - flexibility * start.limit,
                             sense * start.rate - flexibility * start.limit_rate, sense * path - flexibility * limit,
                             sense * rate - flexibility * limit_rate, step};
    return first_fall([&](double x) { return sense * start.slip - reach.value(x); }, 1.0, 0.0);
  }

 private:
  // Lets it slide one way, if it comes so far in the step.
  void slide(const CornerGrip& start, double step, ContactFriction friction, double way) {
    const double flexibility = 1.0 / friction.tangential_stiffness;
    const double before = way * start.path - flexibility * start.limit,
                 change = way * path - flexibility * limit - before,
                 rise = step * (way * start.rate - flexibility * start.limit_rate);
    double reach = before + change, share = 1.0;
    if (rise > 0.0 && 2.0 * change < rise) {
      const double top = 0.5 * rise / (rise - change);  // of the parabola, in the step
      reach = before + 0.5 * rise * top;
      share = top * top;
    }
    // At the same instant again, after an event elsewhere, it goes on sliding.
    constexpr double round_off = 1e-12;  // of the path under the limit
    const bool goes_on =
        step == 0.0 && start.slides() && start.sense == way && reach >= way * slip - round_off * flexibility * limit;
    if (reach <= way * slip && !goes_on) return;
    slip = way * reach;
    sense = way;
    follows = share;
  }
};

}  // namespace moat
