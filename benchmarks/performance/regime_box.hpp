// Where the regimes of bearing and wall end.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "performance/five_storey_equations.hpp"

namespace moat::performance {

/// Regimes last while displacement and velocity of the base are inside a box; each of its sides is one event.
enum Side : std::size_t { least_displacement, greatest_displacement, least_velocity, greatest_velocity };

struct RegimeBox {
  static constexpr double none = std::numeric_limits<double>::infinity();
  std::array<double, 4> bounds{-none, none, -none, none};
  std::array<bool, 4> of_wall{};  ///< or of the bearing

  [[nodiscard]] bool holds(double base, double velocity) const {
    return base >= bounds[least_displacement] && base <= bounds[greatest_displacement] &&
           velocity >= bounds[least_velocity] && velocity <= bounds[greatest_velocity];
  }
  /// >= 0 inside.
  [[nodiscard]] double margin(Side side, double base, double velocity) const {
    const double value = side <= greatest_displacement ? base : velocity;
    return side == least_displacement || side == least_velocity ? value - bounds[side] : bounds[side] - value;
  }
  void narrow(Side side, double bound, bool wall) {
    const bool narrower =
        side == least_displacement || side == least_velocity ? bound > bounds[side] : bound < bounds[side];
    if (!narrower) return;
    bounds[side] = bound;
    of_wall[side] = wall;
  }
};

/// Yield and reloading are noticed this much beyond, relative, lest round-off switch them (as in moat).
inline constexpr double noticed = 1e-9;

inline RegimeBox box_of(const FiveStoreys& building, const Regimes& regimes) {
  RegimeBox box;
  const double reach = building.yield_displacement * (1.0 + noticed);
  if (regimes.sliding == 0) {
    box.narrow(least_displacement, regimes.slip - reach, false);
    box.narrow(greatest_displacement, regimes.slip + reach, false);
  } else {
    box.narrow(regimes.sliding > 0 ? least_velocity : greatest_velocity, 0.0, false);
  }
  if (regimes.side == 0) {
    box.narrow(least_displacement, -building.gap, true);
    box.narrow(greatest_displacement, building.gap, true);
  } else {
    const bool right = regimes.side > 0;
    box.narrow(right ? least_displacement : greatest_displacement, regimes.side * building.gap, true);
    // The force of a loaded contact ends, and that of a released one begins again, at 1 + z d'/v0 = 0.
    const double speed = -regimes.side * regimes.approach_speed / building.impact_damping;
    if (regimes.released)
      box.narrow(right ? greatest_velocity : least_velocity, speed * (1.0 - noticed), true);
    else
      box.narrow(right ? least_velocity : greatest_velocity, speed, true);
  }
  return box;
}

/// The regimes beyond one side of their box.
inline Regimes beyond(const FiveStoreys& building, const RegimeBox& box, Side side, Regimes regimes, double base,
                      double velocity) {
  if (!box.of_wall[side]) {
    if (regimes.sliding == 0) {
      regimes.sliding = side == greatest_displacement ? 1 : -1;
    } else {
      regimes.slip = base - regimes.sliding * building.yield_displacement;
      regimes.sliding = 0;
    }
  } else if (regimes.side == 0) {
    regimes.side = side == greatest_displacement ? 1 : -1;
    regimes.released = false;
    regimes.approach_speed = std::max(regimes.side * velocity, slowest_approach);
  } else if (side <= greatest_displacement) {
    regimes.side = 0;
  } else {
    regimes.released = !regimes.released;
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
  Side side;
  double fraction;  ///< of the step
};

/// The first crossing of the box's border on the path, if there is one, also where the base turns and comes back.
inline std::optional<Crossing> first_crossing(const RegimeBox& box, const BasePath& path) {
  const bool outside = !box.holds(path.end, path.end_velocity);
  const bool turns = path.start_velocity * path.end_velocity < 0.0;
  if (!outside && !turns) return std::nullopt;
  const double turn = turns ? path.start_velocity / (path.start_velocity - path.end_velocity) : 1.0;
  std::optional<Crossing> first;
  for (const Side side : {least_displacement, greatest_displacement, least_velocity, greatest_velocity}) {
    const auto margin = [&](double x) { return box.margin(side, path.displacement(x), path.velocity(x)); };
    double high = 1.0;
    if (box.margin(side, path.end, path.end_velocity) >= 0.0) {
      if (!turns || side >= least_velocity || margin(turn) >= 0.0) continue;
      high = turn;
    }
    double low = 0.0;
    double above = margin(low), below = margin(high);
    if (above <= 0.0) high = low;
    for (int count = 0; count < 40 && high - low > 1e-9; ++count) {
      double x = low + (high - low) * above / (above - below);
      if (count % 3 == 2) x = 0.5 * (low + high);
      const double value = margin(x);
      (value > 0.0 ? low : high) = x;
      (value > 0.0 ? above : below) = value;
      if (std::abs(value) < 1e-12) break;
    }
    if (!first || high < first->fraction) first = Crossing{side, high};
  }
  return first;
}

}  // namespace moat::performance
