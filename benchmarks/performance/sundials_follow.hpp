// Steps of SUNDIALS through a motion, restarted at every event.
#pragma once

#include <nvector/nvector_serial.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "motions/ground_motion.hpp"
#include "performance/sundials_vectors.hpp"

namespace moat::performance {

inline constexpr double intervals_in_longest_step = 20.0;

/// What is done about the ground's acceleration, which bends at every sample.
enum class GroundKinks {
  left_to_error_control,  ///< steps of at most twenty intervals, lest they leap over a motion that begins slowly
  steps_at_most_the_interval,
  stops_at_samples,
};

inline double longest_step(const GroundMotion& motion, GroundKinks kinks) {
  return motion.time_step() * (kinks == GroundKinks::left_to_error_control ? intervals_in_longest_step : 1.0);
}

/// Steps any integrator of SUNDIALS through the motion.
///
///     int step(double last, double& t)          one step, not beyond `last`; 2 where a margin was crossed, 1 at `last`
///     void find_crossings(int* found)
///     void restart(double t)                    from y at t
///     void interpolate(double t)                into `between`, inside the last step
///
/// A step longer than the interval of the samples is looked at inside as well, lest a peak be missed.
template <class Problem, class Integrator>
void follow(Problem& problem, Integrator& integrator, const SundialsVectors& vectors, GroundKinks kinks) {
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
      std::array<int, Problem::sides> found{};
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
