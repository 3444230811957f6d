// The five-storey building as SUNDIALS sees it, its equations written by hand for this very building.
#pragma once

#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <array>
#include <cmath>

#include "motions/ground_motion.hpp"
#include "performance/five_peaks.hpp"
#include "performance/five_storey_equations.hpp"
#include "performance/regime_box.hpp"

namespace moat::performance {

/// y = (u, v), restarted at every change of regime.
struct SundialsProblem {
  explicit SundialsProblem(const GroundMotion& ground_motion) : motion{&ground_motion} {}

  static constexpr int sides = 4;  ///< of the box: functions whose roots are events

  FiveStoreys building;
  Regimes regimes;
  RegimeBox box = box_of(building, regimes);
  Line bearing = bearing_line(building, regimes);
  const GroundMotion* motion;
  FivePeaks peaks;

  static Values displacements(const realtype* y) {
    return {{Values::Pair{y[0], y[3]}, Values::Pair{y[1], y[4]}, Values::Pair{y[2], y[5]}}};
  }
  static Values velocities(const realtype* y) { return displacements(y + floors + 1); }

  [[nodiscard]] Values acceleration(double ground, const realtype* y) const {
    const double base = y[0], velocity = y[floors + 1];
    const double force =
        bearing.stiffness * base + bearing.constant + regimes.side * wall_force(building, regimes, base, velocity);
    return accelerations(building, displacements(y), velocities(y), force, ground);
  }

  static int rate(realtype t, N_Vector y, N_Vector ydot, void* data) {
    const auto& problem = *static_cast<const SundialsProblem*>(data);
    const realtype* from = NV_DATA_S(y);
    realtype* to = NV_DATA_S(ydot);
    const Values a = problem.acceleration(problem.motion->acceleration_at(t), from);
    for (std::size_t i = 0; i <= floors; ++i) {
      to[i] = from[floors + 1 + i];
      to[floors + 1 + i] = a[i];
    }
    return 0;
  }

  static int jacobian(realtype, N_Vector y, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector, N_Vector) {
    const auto& problem = *static_cast<const SundialsProblem*>(data);
    const FiveStoreys& building = problem.building;
    const realtype* state = NV_DATA_S(y);
    const auto entry = [&](std::size_t row, std::size_t column) -> realtype& {
      return SM_ELEMENT_D(matrix, static_cast<sunindextype>(row), static_cast<sunindextype>(column));
    };
    constexpr std::size_t half = floors + 1;
    for (std::size_t i = 0; i < half; ++i) entry(i, half + i) = 1.0;
    const double elastic = building.square_frequency, viscous = elastic * building.stiffness_factor;
    const auto couple = [&](std::size_t below, std::size_t above, double stiffness, double damping) {
      const std::array<std::size_t, 2> ends{below, above};
      for (const std::size_t row : ends)
        for (const std::size_t column : ends) {
          const double sign = (row == column ? -1.0 : 1.0) * (row == 0 ? building.mass_ratio : 1.0);
          entry(half + row, column) += sign * stiffness;
          entry(half + row, half + column) += sign * damping;
        }
    };
    for (std::size_t i = 1; i <= floors; ++i) {
      couple(i - 1, i, elastic, viscous);
      couple(0, i, 0.0, building.mass_factor);
    }
    double stiffness = problem.bearing.stiffness, damping = 0.0;
    const Regimes& regimes = problem.regimes;
    const double indentation = regimes.side * state[0] - building.gap;
    if (regimes.side != 0 && !regimes.released && indentation > 0.0) {
      const double root = building.impact_stiffness * std::sqrt(indentation);
      const double ratio = speed_ratio(regimes, state[half]);
      stiffness += 1.5 * root * (1.0 + building.impact_damping * ratio);
      if (std::abs(ratio) < largest_speed_ratio)
        damping = root * indentation * building.impact_damping / regimes.approach_speed;
    }
    entry(half, 0) -= building.inverse_base_mass * stiffness;
    entry(half, half) -= building.inverse_base_mass * damping;
    return 0;
  }

  static int margins(realtype, N_Vector y, realtype* margin, void* data) {
    const auto& problem = *static_cast<const SundialsProblem*>(data);
    const realtype* state = NV_DATA_S(y);
    for (std::size_t side = 0; side < sides; ++side) {
      const double value = problem.box.margin(static_cast<Side>(side), state[0], state[floors + 1]);
      margin[side] = std::isfinite(value) ? value : 1.0;
    }
    return 0;
  }

  [[nodiscard]] Peaks sample(double t, const realtype* y) const {
    const double ground = motion->acceleration_at(t);
    const Values a = acceleration(ground, y);
    return {y[0], y[floors], a[0] + ground, a[floors] + ground, wall_force(building, regimes, y[0], y[floors + 1])};
  }

  /// `found`: of each side of the box, not zero where it was crossed.
  void change_regimes(double t, const realtype* y, const std::array<int, sides>& found) {
    for (std::size_t side = 0; side < sides; ++side)
      if (found[side] != 0) regimes = beyond(building, box, static_cast<Side>(side), regimes, y[0], y[floors + 1]);
    box = box_of(building, regimes);
    bearing = bearing_line(building, regimes);
    peaks.restart(t, sample(t, y));
  }
};

}  // namespace moat::performance
