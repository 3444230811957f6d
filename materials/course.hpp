// Where the force of a law with memory has corners.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "materials/response.hpp"

namespace moat {

/// The part of a path on which the force of a law with memory is smooth: the motion keeps its direction, and the next
/// corner of the force in this direction is not reached.
///
///     F ^        .-'|  corner          A law follows a move in one direction exactly, for any length of the step. Its
///       |    .-'    |                  force bends where the motion turns, and at deformations that it knows. Steps
///       |  /        |                  end there: both are located like any change of regime.
///     --+-/---------+----> d
///
/// A law keeps a `Course course` in its State, which is trivially copyable, and forwards to the functions below. Where
/// its force has corners besides the turns it offers, m, +-infinity for none:
///
///     double next_corner(State const& state, double from, int direction) const
///
/// the first corner beyond the deformation `from`, in a direction of -1 or +1.
struct Course {
  int direction = 0;                                        ///< of the motion, -1 or +1; 0 before it has begun
  double corner = std::numeric_limits<double>::infinity();  ///< m, a deformation

  /// A rate enters the margin as the distance in this time, s, which is of the order of 1/omega of an isolated
  /// building.
  static constexpr double time_of_rate = 1.0;
  /// m: a corner must not be passed by round-off.
  static constexpr double threshold = 1e-10;

  friend bool operator==(const Course&, const Course&) = default;

  /// The regime margin (LawWithRegimes), m.
  [[nodiscard]] double margin(double deformation, double rate) const {
    if (direction == 0) return std::numeric_limits<double>::infinity();
    return std::min(direction * rate * time_of_rate, direction * (corner - deformation) + threshold);
  }
};

namespace detail {

template <class Law>
Course course_from(const Law& law, const typename Law::State& state, double deformation, int direction) {
  if constexpr (requires { law.next_corner(state, deformation, direction); })
    return {direction, law.next_corner(state, deformation, direction)};
  else
    return {direction, direction * std::numeric_limits<double>::infinity()};
}

}  // namespace detail

/// The course of a step from the committed state: its own, or the one that begins with the first motion, by `moved` m
/// from a deformation.
template <class Law>
Course course_of_step(const Law& law, const typename Law::State& committed, double from, double moved) {
  if (committed.course.direction != 0 || moved == 0.0) return committed.course;
  return detail::course_from(law, committed, from, moved > 0.0 ? 1 : -1);
}

/// next_regime() of a law with a course: the law is led to the deformation, where it turns or passes its corner.
template <class Law>
typename Law::State next_on_course(const Law& law, const typename Law::State& committed, double deformation,
                                   double rate) {
  typename Law::State next;
  law.evaluate(committed, deformation, rate, next);
  const int direction = rate > 0.0 ? 1 : rate < 0.0 ? -1 : committed.course.direction;
  next.course = detail::course_from(law, next, deformation + direction * Course::threshold, direction);
  return next;
}

}  // namespace moat
