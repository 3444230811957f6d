// The motion of a model at one instant.
#pragma once

#include "base/vector.hpp"

namespace moat {

/// The motion of all degrees of freedom at one instant, relative to the ground. Every vector has one entry more than
/// there are degrees of freedom: the last belongs to the ground and stays zero.
struct MotionState {
  double time = 0.0;    ///< s
  Vector displacement;  ///< m
  Vector velocity;      ///< m/s
  Vector acceleration;  ///< m/s^2
  Vector jerk;          ///< m/s^3, rate of the absolute acceleration: jumps with force rates, not with the ground
};

}  // namespace moat
