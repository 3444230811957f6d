// A mass on a law and a spring, in very short explicit steps: no code of elements, events or integrators of moat.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "materials/response.hpp"

namespace moat::testing {

struct OscillatorPeaks {
  double displacement = 0.0, acceleration = 0.0, force = 0.0;  ///< m, m/s^2 absolute, N of the law
};

/// m a = -F - k u - m a_g(t) from rest.
struct ReferenceOscillator {
  double mass = 0.0, spring = 0.0;  ///< kg, N/m
  double interval = 0.01;           ///< s, between samples
  std::vector<double> ground{};     ///< m/s^2, linear between samples, 0 behind the last

  /// Position Verlet steps, of second order while the law is smooth: u half a step, the force at its end with the
  /// speed there, u the other half. Regimes change at the first step that is beyond their margin.
  template <ForceLaw Law>
  [[nodiscard]] OscillatorPeaks follow(const Law& law, int steps_per_interval) const {
    const double h = interval / steps_per_interval;
    typename Law::State state{}, trial;
    double u = 0.0, v = 0.0, at = 0.0, rate_there = 0.0;
    OscillatorPeaks peaks;
    for (std::size_t i = 0; i + 1 < ground.size(); ++i)
      for (int k = 0; k < steps_per_interval; ++k) {
        const double share = (k + 0.5) / steps_per_interval;
        const double a_g = ground[i] + share * (ground[i + 1] - ground[i]);
        const double middle = u + 0.5 * h * v;
        if constexpr (LawWithRegimes<Law>)
          for (int changes = 0; changes < 4 && law.regime_margin(state, middle, v) < 0.0; ++changes)
            state = law.next_regime(state, middle, v);
        // The law at the middle of the step; its dashpot with the mean speed of the step, by iteration.
        double speed = v, force = 0.0, acceleration = 0.0;
        for (int pass = 0; pass < 3; ++pass) {
          force = respond(law, state, middle, speed, {h, at, rate_there}, trial).force;
          acceleration = -(force + spring * middle) / mass - a_g;
          speed = v + 0.5 * h * acceleration;
        }
        state = trial;
        at = middle;
        rate_there = speed;
        v += h * acceleration;
        u = middle + 0.5 * h * v;
        peaks.displacement = std::max(peaks.displacement, std::abs(middle));
        peaks.acceleration = std::max(peaks.acceleration, std::abs(acceleration + a_g));
        peaks.force = std::max(peaks.force, std::abs(force));
      }
    return peaks;
  }
};

}  // namespace moat::testing
