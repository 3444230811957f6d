// Coulomb friction of a corner along an edge.
#pragma once

#include <algorithm>
#include <limits>

#include "base/hermite.hpp"
#include "elements/block/regime_search.hpp"

namespace moat {

/// Coulomb friction of a contact. Either the stiffness or the ratio is given.
struct ContactFriction {
  double coefficient = 0.0;           ///< mu, 0 to 1; 0 is no friction
  double tangential_stiffness = 0.0;  ///< k_t > 0 N/m, a constant
  double tangential_ratio = 0.0;      ///< k_t over the elastic tangent of the normal contact, 0 to 1
};

/// A normal contact at rest, F_e(d): its law at zero rate, at an instant.
struct ElasticNormal {
  double indentation = 0.0, rate = 0.0;  ///< d, m, and d', m/s
  double force = 0.0;                    ///< F_e, N
  double stiffness = 0.0;                ///< K = dF_e/dd, N/m
  double curvature = 0.0;                ///< dK/dd, N/m^2
};

/// A corner that moves by u_t along an edge under the normal force F_n. By return mapping, with the slip s as history:
///
///     F_t = k_t (u_t - s),  |F_t| <= mu F_n,  s follows where it must;  without contact s = u_t
///
/// A corner that slides along t has s = u_t - mu F_n/k_t =: g, and it sticks from the instant on where g is largest.
/// There s is the largest of its value before and of g inside the step, where g is the parabola through its value and
/// rate at the start and its value at the end. With the value at the end alone the corner would stick from the start of
/// a step in which it still slides, and every sticking would begin with an error of second order that stays until it
/// ends.
///
/// The spring is a constant, or follows the normal contact, k_t = ratio K(d). Then new area of contact carries no
/// tangential force, and area that separates gives up its own:
///
///     dF_t = k_t du_t  while k_t grows,    dF_t = k_t du_t + F_t dk_t/k_t  while it falls
///
/// The stored energy is F_t^2/(2 k_t), and a change of k_t turns |dk_t|/k_t of it into heat: the spring never gains
/// energy. In a step in which k_t grows its mean is ratio dF_e/dd, the secant of F_e, which holds from touch on.
/// Source: the no-slip solution of Mindlin and Deresiewicz (1953) with the limit of Coulomb, as codes of discrete
/// elements use it: Walton and Braun (1986); Thornton, Cummins and Cleary (2013) for the falling stiffness.
struct CornerGrip {
  double path = 0.0, rate = 0.0, second_rate = 0.0;  ///< u_t, m, and its rates
  double slip = 0.0;                                 ///< s, m
  double force = 0.0, force_rate = 0.0;              ///< F_t, N, N/s
  double limit = 0.0, limit_rate = 0.0;              ///< mu F_n, N, N/s
  double spring = 0.0, spring_rate = 0.0;            ///< k_t, N/m, N/(m s)
  double sense = 0.0;                                ///< of sliding in the step: -1 or 1; 0 where it sticks throughout
  double follows = 0.0;                              ///< dF_t/d(sense limit), 0 to 1: 1 where it slides at the end
  double stiffness = 0.0;                            ///< dF_t/du_t, N/m
  double by_indentation = 0.0;                       ///< dF_t/dd of a spring that follows the normal contact, N/m
  ElasticNormal normal{};                            ///< where the spring follows it

  /// Whether there is friction now.
  [[nodiscard]] bool holds() const { return limit > 0.0; }
  /// Whether the corner slides at the end of the step.
  [[nodiscard]] bool slides() const { return follows == 1.0; }
  /// J.
  [[nodiscard]] double stored() const { return force == 0.0 ? 0.0 : 0.5 * force * force / spring; }

  /// The friction at this path and rate under a normal force, N, `step` s after `start`.
  void follow(const CornerGrip& start, double step, ContactFriction friction, double normal_force,
              const ElasticNormal& elastic = {}) {
    normal = elastic;
    spring = friction.tangential_stiffness + friction.tangential_ratio * std::max(normal.stiffness, 0.0);
    limit = spring > 0.0 ? friction.coefficient * std::max(normal_force, 0.0) : 0.0;
    sense = follows = force = stiffness = by_indentation = 0.0;
    slip = path;
    if (!holds()) return;
    const StepSpring in_step = spring_since(start, friction);
    slip = in_step.slip;
    for (const double way : {1.0, -1.0}) slide(start, step, in_step, way);
    force = in_step.stiffness * (path - slip);
    // It slid both ways.
    if (const double way = force > 0.0 ? 1.0 : -1.0; way * force > limit) {
      slip = path - way * limit / in_step.stiffness;
      sense = way;
      follows = 1.0;
    }
    if (slides()) force = sense * limit;
    stiffness = (1.0 - follows) * in_step.stiffness;
    by_indentation = (1.0 - follows) * in_step.stiffness_slope * (path - (in_step.grows ? start.path : slip));
    if (in_step.grows) slip = path - force / spring;
  }
  /// After follow(): the rates of forces, from that of the normal force, N/s.
  void find_rates(ContactFriction friction, double normal_force_rate, double acceleration) {
    second_rate = acceleration;
    limit_rate = holds() ? friction.coefficient * normal_force_rate : 0.0;
    spring_rate = friction.tangential_ratio * normal.curvature * normal.rate;
    force_rate = slides()  ? sense * limit_rate
                 : holds() ? spring * rate + std::min(spring_rate, 0.0) * (path - slip)
                           : 0.0;
  }

  /// Whether it began to slide after `start`, also the other way. Where it ends to slide its force has no corner.
  [[nodiscard]] bool begins_to_slide(const CornerGrip& start) const {
    return sense != 0.0 && start.holds() && !(start.slides() && start.sense == sense);
  }
  /// Where between `start`, `step` s before, and now it began to slide, as a fraction of the step; NaN if it did not.
  [[nodiscard]] double slide_begin(const CornerGrip& start, double step, ContactFriction friction) const {
    if (step <= 0.0 || !begins_to_slide(start)) return std::numeric_limits<double>::quiet_NaN();
    const StepSpring in_step = spring_since(start, friction);
    const Reach before = reach(start, in_step.start, sense), after = reach(*this, in_step.end, sense);
    const HermiteCubic cubic{before.value, before.rate, after.value, after.rate, step};
    return first_fall([&](double x) { return sense * in_step.slip - cubic.value(x); }, 1.0, 0.0);
  }

 private:
  // The limit as a deformation of the spring at an end of the step, and the speed that the spring sees there.
  struct SpringEnd {
    double flexibility, flexibility_rate = 0.0;  // m/N, m/(N s)
    double share_of_rate = 1.0;
  };
  // The spring of a step: F_t = stiffness (u_t - slip) without sliding.
  struct StepSpring {
    double stiffness;  // N/m
    double slip;       // m
    SpringEnd start, end;
    bool grows = false;
    double stiffness_slope = 0.0;  // by the indentation, N/m^2
  };
  // A reach g and its rate, m and m/s.
  struct Reach {
    double value, rate;
  };

  [[nodiscard]] StepSpring spring_since(const CornerGrip& start, ContactFriction friction) const {
    if (friction.tangential_ratio == 0.0) return {spring, start.slip, {1.0 / spring}, {1.0 / spring}};
    if (spring < start.spring) {
      const auto end = [](const CornerGrip& grip) {
        return SpringEnd{1.0 / grip.spring, -grip.spring_rate / (grip.spring * grip.spring)};
      };
      return {spring, start.slip, end(start), end(*this), false, friction.tangential_ratio * normal.curvature};
    }
    const double deeper = normal.indentation - start.normal.indentation;
    double mean = 0.5 * (start.spring + spring), slope = 0.0;
    if (deeper > 0.0) {
      mean = std::clamp(friction.tangential_ratio * (normal.force - start.normal.force) / deeper, start.spring, spring);
      slope = (spring - mean) / deeper;
    }
    return {mean,
            start.path - start.force / mean,
            {1.0 / mean, 0.0, start.spring / mean},
            {1.0 / mean, 0.0, spring / mean},
            true,
            slope};
  }
  static Reach reach(const CornerGrip& grip, const SpringEnd& end, double way) {
    return {
        way * grip.path - end.flexibility * grip.limit,
        way * end.share_of_rate * grip.rate - end.flexibility * grip.limit_rate - end.flexibility_rate * grip.limit};
  }

  // Lets it slide one way, if it comes so far in the step.
  void slide(const CornerGrip& start, double step, const StepSpring& in_step, double way) {
    const Reach at_start = reach(start, in_step.start, way);
    const double before = at_start.value, rise = step * at_start.rate,
                 change = way * path - in_step.end.flexibility * limit - before;
    double reached = before + change, share = 1.0;
    if (rise > 0.0 && 2.0 * change < rise) {
      const double top = 0.5 * rise / (rise - change);  // of the parabola, in the step
      reached = before + 0.5 * rise * top;
      share = top * top;
    }
    // At the same instant again, after an event elsewhere, it goes on sliding.
    constexpr double round_off = 1e-12;  // of the path under the limit
    const bool goes_on = step == 0.0 && start.slides() && start.sense == way &&
                         reached >= way * slip - round_off * in_step.end.flexibility * limit;
    if (reached <= way * slip && !goes_on) return;
    slip = way * reached;
    sense = way;
    follows = share;
  }
};

}  // namespace moat
