// Where the regimes of bearing and wall end.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "performance/five_storey_equations.hpp"

namespace moat::performance {

/// Of the bearing's corner (m or m/s), of the gap (m), and of the force of a contact (1): an event where one falls
/// below zero.
using Margins = std::array<double, 3>;
enum Event { bearing_corner, gap_end, force_end };

/// Yield and reloading are noticed this much beyond, relative, so that round-off does not switch them (as in moat).
inline constexpr double noticed = 1e-9;

inline Margins margins_of(const FiveStoreys& building, const Regimes& regimes, double base, double velocity) {
  const double bearing = regimes.sliding == 0
                             ? building.yield_displacement * (1.0 + noticed) - std::abs(base - regimes.slip)
                             : regimes.sliding * velocity;
  if (regimes.side == 0) return {bearing, building.gap - std::abs(base), 1.0};
  const double factor = 1.0 + building.impact_damping * regimes.side * velocity / regimes.approach_speed;
  return {bearing, regimes.side * base - building.gap, regimes.released ? noticed - factor : factor};
}

/// Per second, where velocity and acceleration of the base are these.
inline Margins margin_rates(const FiveStoreys& building, const Regimes& regimes, double base, double velocity,
                            double acceleration) {
  const double stretching = base > regimes.slip ? velocity : -velocity;
  const double bearing = regimes.sliding == 0 ? -stretching : regimes.sliding * acceleration;
  if (regimes.side == 0) return {bearing, base > 0.0 ? -velocity : velocity, 0.0};
  const double factor = building.impact_damping * regimes.side * acceleration / regimes.approach_speed;
  return {bearing, regimes.side * velocity, regimes.released ? -factor : factor};
}

inline Regimes beyond(const FiveStoreys& building, Regimes regimes, Event event, double base, double velocity) {
  if (event == force_end) {
    regimes.released = !regimes.released;
  } else if (event == gap_end) {
    const int touched = base > 0.0 ? 1 : -1;
    regimes.side = regimes.side == 0 ? touched : 0;
    regimes.released = false;
    regimes.approach_speed = std::max(touched * velocity, slowest_approach);
  } else if (regimes.sliding == 0) {
    regimes.sliding = base > regimes.slip ? 1 : -1;
  } else {
    regimes.slip = base - regimes.sliding * building.yield_displacement;
    regimes.sliding = 0;
  }
  return regimes;
}

/// Displacement and velocity of the base at both ends of a step of length h, s.
struct BasePath {
  double start = 0.0, start_velocity = 0.0, end = 0.0, end_velocity = 0.0, h = 0.0;

  /// The cubic through all four, 0 <= x <= 1.
  [[nodiscard]] double displacement(double x) const {
    const double rise = end - start, left = h * start_velocity - rise, right = rise - h * end_velocity;
    return start + x * rise + x * (1.0 - x) * ((1.0 - x) * left + x * right);
  }
  [[nodiscard]] double velocity(double x) const {
    const double rise = end - start, left = h * start_velocity - rise, right = rise - h * end_velocity;
    return (rise + (1.0 - x) * (1.0 - 3.0 * x) * left + x * (2.0 - 3.0 * x) * right) / h;
  }
};

struct Crossing {
  Event event;
  double fraction;  ///< of the step
};

/// The first event on the path, if there is one, also where the base turns and comes back.
inline std::optional<Crossing> first_crossing(const FiveStoreys& building, const Regimes& regimes,
                                              const BasePath& path) {
  const bool turns = path.start_velocity * path.end_velocity < 0.0;
  const Margins at_end = margins_of(building, regimes, path.end, path.end_velocity);
  if (!turns && *std::min_element(at_end.begin(), at_end.end()) >= 0.0) return std::nullopt;
  const double turn = turns ? path.start_velocity / (path.start_velocity - path.end_velocity) : 1.0;
  std::optional<Crossing> first;
  for (const Event event : {bearing_corner, gap_end, force_end}) {
    const auto margin = [&](double x) {
      return margins_of(building, regimes, path.displacement(x), path.velocity(x))[event];
    };
    const bool of_displacement = event == gap_end || (event == bearing_corner && regimes.sliding == 0);
    double low = 0.0, high = at_end[event] < 0.0 ? 1.0 : turn;
    double above = margin(low), below = margin(high);
    if (below >= 0.0 || (at_end[event] >= 0.0 && !of_displacement)) continue;
    if (above <= 0.0) high = low;
    for (int count = 0; count < 40 && high - low > 1e-9; ++count) {
      const double x = count % 3 == 2 ? 0.5 * (low + high) : low + (high - low) * above / (above - below);
      const double value = margin(x);
      (value > 0.0 ? low : high) = x;
      (value > 0.0 ? above : below) = value;
      if (std::abs(value) < 1e-12) break;
    }
    if (!first || high < first->fraction) first = Crossing{event, high};
  }
  return first;
}

}  // namespace moat::performance
