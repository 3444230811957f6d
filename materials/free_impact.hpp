// A law replayed in free flight.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "materials/contact_state.hpp"
#include "materials/response.hpp"

namespace moat {
namespace free_impact {

// Indentation and rate.
struct Motion {
  double indentation, rate;
};

// One step of the fifth-order method of Dormand and Prince for m d'' = -F(d, d'), and the difference to the
// fourth-order one inside it.
template <class Slope>
Motion dormand_prince(const Slope& slope, const Motion& start, double h, Motion& difference) {
  static constexpr std::array<std::array<double, 6>, 6> weights{{
      {1.0 / 5.0},
      {3.0 / 40.0, 9.0 / 40.0},
      {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
      {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
      {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
      {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0},
  }};
  static constexpr std::array<double, 7> errors{71.0 / 57600.0,      0.0,          -71.0 / 16695.0, 71.0 / 1920.0,
                                                -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0};
  std::array<Motion, 7> slopes;
  slopes[0] = slope(start);
  Motion end{};
  for (std::size_t stage = 0; stage < 6; ++stage) {
    end = start;
    for (std::size_t i = 0; i <= stage; ++i) {
      end.indentation += h * weights[stage][i] * slopes[i].indentation;
      end.rate += h * weights[stage][i] * slopes[i].rate;
    }
    slopes[stage + 1] = slope(end);
  }
  difference = {};
  for (std::size_t i = 0; i < 7; ++i) {
    difference.indentation += h * errors[i] * slopes[i].indentation;
    difference.rate += h * errors[i] * slopes[i].rate;
  }
  return end;
}

}  // namespace free_impact

/// The restitution that a law delivers in the free impact of two bodies: m d'' = -F(d, d') from d = 0,
/// d' = v0 until the contact ends; then the bodies fly on, so that e = -d'/v0.
///
/// effective_mass m = m1 m2/(m1 + m2) > 0 kg, approach_speed v0 > 0 m/s; below least_approach_speed laws with d'/v0
/// divide by that floor here too. The error is below 1e-9: adaptive Dormand-Prince, the end located. Throws Error if
/// the contact has not ended after 1e5 steps.
template <ContactLaw Law>
double delivered_restitution(const Law& law, double effective_mass, double approach_speed) {
  using free_impact::Motion;
  constexpr double tolerance = 1e-12;
  constexpr int most_steps = 100000;

  const typename Law::State contact = law.next_regime({}, 0.0, approach_speed);
  const auto slope = [&](const Motion& motion) {
    typename Law::State trial;
    const double force = law.evaluate(contact, motion.indentation, motion.rate, trial).force;
    return Motion{motion.rate, -force / effective_mass};
  };
  const auto margin = [&](const Motion& motion) { return law.regime_margin(contact, motion.indentation, motion.rate); };

  const double duration = law.contact_duration(effective_mass, approach_speed);
  const double depth = duration * approach_speed;
  Motion now{0.0, approach_speed};
  // Laws with damping that grows from nothing have no bounded slope at touch: begin with a short step.
  double h = 1e-6 * duration;
  for (int count = 0; count < most_steps; ++count) {
    Motion difference;
    const Motion next = free_impact::dormand_prince(slope, now, h, difference);
    const double error =
        std::max(std::abs(difference.indentation) / depth, std::abs(difference.rate) / approach_speed) / tolerance;
    const double change = 0.9 * std::pow(std::max(error, 1e-10), -0.2);
    if (error > 1.0) {
      h *= std::max(change, 0.1);
      continue;
    }
    if (margin(next) <= 0.0) {
      // Shorter steps from here until one ends where the contact does.
      double before = 0.0, beyond = h;
      Motion end = next;
      while (beyond - before > 1e-13 * duration) {
        const double middle = 0.5 * (before + beyond);
        if (middle == before || middle == beyond) break;  // damping may make the duration shorter than the digits of h
        end = free_impact::dormand_prince(slope, now, middle, difference);
        (margin(end) > 0.0 ? before : beyond) = middle;
      }
      return -end.rate / approach_speed;
    }
    now = next;
    h *= std::min(change, 5.0);
  }
  throw Error{"The contact of a free impact does not end. Check the damping of the impact law."};
}

}  // namespace moat
