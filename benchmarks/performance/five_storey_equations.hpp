// The five-storey building in its moat, in plain SI and without moat: the equations that SUNDIALS solves.
//
// It is the building of benchmarks/paper/paper_building.hpp: base 0 and floors 1 to 5, displacements u relative to the
// ground. With the floors' mass m, storey stiffness k and Rayleigh factors alpha (1/s) and beta (s):
//
//     s_i  = k/m ((u_i - u_{i-1}) + beta (v_i - v_{i-1})),   s_6 = 0
//     a_i  = s_{i+1} - s_i - alpha (v_i - v_0) - a_g                                 i = 1 ... 5
//     a_0  = (m s_1 + m alpha sum (v_i - v_0) - F_bearing - F_wall) / m_0 - a_g
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace moat::performance {

inline constexpr int floors = 5, unknowns = floors + 1;

/// One number for the base (0) and for each floor (1 to 5).
using Values = Eigen::Matrix<double, unknowns, 1>;

struct FiveStoreys {
  double base_mass = 550e3, floor_mass = 500e3;  // kg
  double storey_stiffness = 1e9;                 // N/m
  double damping_ratio = 0.05;
  double yield_displacement = 0.01, elastic_stiffness = 193e6, post_yield_stiffness = 19.3e6;  // m, N/m
  double gap = 0.1;                                                                            // m
  double impact_stiffness = 2.95e9;                                                            // N/m^1.5
  double impact_damping = 0.75 * (1.0 - 0.65 * 0.65);  // of Hertz-damp, e = 0.65

  double square_frequency = storey_stiffness / floor_mass;  // k/m, 1/s^2
  double mass_ratio = floor_mass / base_mass, inverse_base_mass = 1.0 / base_mass;
  double mass_factor = 0.0, stiffness_factor = 0.0;  // alpha, beta

  FiveStoreys() {
    const double first = angular_frequency(1), second = angular_frequency(2);
    mass_factor = 2.0 * damping_ratio * first * second / (first + second);
    stiffness_factor = 2.0 * damping_ratio / (first + second);
  }

  /// Returns that of a uniform chain of five held at its foot: w_j = 2 sqrt(k/m) sin((2j - 1) pi / (2 (2 n + 1))).
  [[nodiscard]] double angular_frequency(int mode) const {
    return 2.0 * std::sqrt(square_frequency) *
           std::sin((2 * mode - 1) * std::numbers::pi / (2.0 * (2.0 * floors + 1.0)));
  }
};

/// The state of bearing and wall.
struct Regimes {
  int sliding = 0;              ///< direction in which the bearing yields; 0: elastic about its slip
  double slip = 0.0;            ///< m
  int side = 0;                 ///< of the wall that is touched: +1 right, -1 left; 0: none
  bool released = false;        ///< still indented, but the force has ended
  double approach_speed = 0.0;  ///< m/s, at touch
};

/// N against positive displacement of the base.
inline double bearing_force(const FiveStoreys& building, const Regimes& regimes, double base) {
  const double sliding_part = building.elastic_stiffness - building.post_yield_stiffness;
  if (regimes.sliding != 0)
    return building.post_yield_stiffness * base + sliding_part * regimes.sliding * building.yield_displacement;
  return building.elastic_stiffness * base - sliding_part * regimes.slip;
}

// As in materials/contact/contact_state.hpp and materials/contact/viscous_hertz_contact.hpp.
inline constexpr double slowest_approach = 1e-4, largest_speed_ratio = 100.0;

/// N, >= 0.
inline double wall_force(const FiveStoreys& building, const Regimes& regimes, double base, double base_velocity) {
  const double indentation = regimes.side * base - building.gap;
  if (regimes.side == 0 || regimes.released || indentation <= 0.0) return 0.0;
  const double ratio =
      std::clamp(regimes.side * base_velocity / regimes.approach_speed, -largest_speed_ratio, largest_speed_ratio);
  return building.impact_stiffness * std::sqrt(indentation) * indentation * (1.0 + building.impact_damping * ratio);
}

/// `ground`: its acceleration, m/s^2.
inline Values accelerations(const FiveStoreys& building, const Regimes& regimes, const Values& u, const Values& v,
                            double ground) {
  const double base_force =
      bearing_force(building, regimes, u[0]) + regimes.side * wall_force(building, regimes, u[0], v[0]);
  const Values w = building.square_frequency * (u + building.stiffness_factor * v);
  const Values drag = building.mass_factor * (v.array() - v[0]).matrix();
  double below = w[1] - w[0];
  Values a;
  a[0] = building.mass_ratio * (below + drag.sum()) - building.inverse_base_mass * base_force - ground;
  for (int i = 1; i <= floors; ++i) {
    const double above = i < floors ? w[i + 1] - w[i] : 0.0;
    a[i] = above - below - drag[i] - ground;
    below = above;
  }
  return a;
}

/// The margins of the bearing's corner (m or m/s), of the gap (m), and of the force of a contact (1). An event is
/// where one falls below zero.
enum Event { bearing_corner, gap_end, force_end, event_count };
using Margins = std::array<double, event_count>;

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

}  // namespace moat::performance
