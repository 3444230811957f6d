// The five-storey building as SUNDIALS sees it: y = (u, v), restarted at every change of regime.
#pragma once

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_nvector.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <array>
#include <memory>
#include <string>

#include "base/error.hpp"
#include "motions/ground_motion.hpp"
#include "performance/five_peaks.hpp"
#include "performance/five_storey_equations.hpp"
#include "performance/regime_box.hpp"

namespace moat::performance {

inline constexpr double intervals_in_longest_step = 20.0;

/// What is done about the ground's acceleration, which bends at every sample.
enum class GroundKinks {
  left_to_error_control,  ///< steps of at most twenty intervals, lest they leap over a motion that begins slowly
  steps_at_most_the_interval,
  stops_at_samples,
};

struct SundialsProblem {
  static constexpr sunindextype size = 2 * (floors + 1);
  static constexpr int sides = 4;

  FiveStoreys building;
  Regimes regimes;
  RegimeBox box = box_of(building, regimes);
  Line bearing = bearing_line(building, regimes);
  const GroundMotion* motion = nullptr;
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

  [[nodiscard]] double longest_step(GroundKinks kinks) const {
    return motion->time_step() * (kinks == GroundKinks::left_to_error_control ? intervals_in_longest_step : 1.0);
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

/// Throws Error for a negative return value.
inline int checked(int flag, const char* call) {
  if (flag < 0) throw Error{std::string{call} + " of SUNDIALS failed with code " + std::to_string(flag) + "."};
  return flag;
}

/// What all of its integrators need, given back at the end.
class SundialsVectors {
 public:
  SundialsVectors() {
    SUNContext made = nullptr;
    checked(-std::abs(SUNContext_Create(nullptr, &made)), "SUNContext_Create");
    context_ = made;
    y = N_VNew_Serial(SundialsProblem::size, context_);
    between = N_VNew_Serial(SundialsProblem::size, context_);
    tolerances = N_VNew_Serial(SundialsProblem::size, context_);
    matrix = SUNDenseMatrix(SundialsProblem::size, SundialsProblem::size, context_);
    solver = SUNLinSol_Dense(y, matrix, context_);
    N_VConst(0.0, y);
  }
  SundialsVectors(const SundialsVectors&) = delete;
  SundialsVectors& operator=(const SundialsVectors&) = delete;
  ~SundialsVectors() {
    SUNLinSolFree(solver);
    SUNMatDestroy(matrix);
    N_VDestroy(tolerances);
    N_VDestroy(between);
    N_VDestroy(y);
    SUNContext_Free(&context_);
  }

  /// Absolute tolerances from the relative one: of 1 cm and 10 cm/s.
  void set_tolerances(double relative) {
    for (sunindextype i = 0; i < SundialsProblem::size; ++i)
      NV_Ith_S(tolerances, i) = relative * (2 * i < SundialsProblem::size ? 0.01 : 0.1);
  }

  [[nodiscard]] SUNContext context() const { return context_; }

  N_Vector y = nullptr, between = nullptr, tolerances = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver solver = nullptr;

 private:
  SUNContext context_ = nullptr;
};

/// Steps any integrator of SUNDIALS through the motion.
///
///     int step(double last, double& t)          one step, not beyond `last`; 2 where a margin was crossed, 1 at `last`
///     void find_crossings(int* found)
///     void restart(double t)                    from y at t
///     void interpolate(double t)                into `between`, inside the last step
///
/// A step longer than the interval of the samples is looked at inside as well, lest a peak be missed.
template <class Integrator>
void follow(SundialsProblem& problem, Integrator& integrator, const SundialsVectors& vectors, GroundKinks kinks) {
  constexpr int margin_crossed = 2, stop_reached = 1;
  const double end = problem.motion->duration(), interval = problem.motion->time_step();
  const realtype *y = NV_DATA_S(vectors.y), *between = NV_DATA_S(vectors.between);
  double t = 0.0, next_sample = 1.0;
  problem.peaks.add(t, problem.sample(t, y));
  while (t < end * (1.0 - 1e-12)) {
    const double last = kinks == GroundKinks::stops_at_samples ? std::min(next_sample * interval, end) : end;
    const double start = t;
    const int what = integrator.step(last, t);
    const double parts = std::ceil((t - start) / interval - 1e-6);
    for (double part = 1.0; part < parts; part += 1.0) {
      const double inside = start + (t - start) * part / parts;
      integrator.interpolate(inside);
      problem.peaks.add(inside, problem.sample(inside, between));
    }
    problem.peaks.add(t, problem.sample(t, y));
    if (what == margin_crossed) {
      std::array<int, SundialsProblem::sides> found{};
      integrator.find_crossings(found.data());
      problem.change_regimes(t, y, found);
      integrator.restart(t);
      if (t >= last * (1.0 - 1e-12)) next_sample += 1.0;
    } else if (what == stop_reached) {
      next_sample += 1.0;
    }
  }
}

}  // namespace moat::performance
