// Scaling of motions, in one direction and in plan, to a measure of intensity.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "base/units.hpp"
#include "motions/ground_motion.hpp"
#include "motions/plan_motion.hpp"

namespace moat {

/// Pseudo-acceleration of an oscillator with this period, from time_step/100 to 1000 s. damping_ratio: >= 0, < 1.
Acceleration spectral_acceleration(const GroundMotion& motion, Time period, double damping_ratio = 0.05);
/// The periods over which average_spectral_acceleration() averages if none are given: ten from 0.2 T to 3 T in equal
/// ratios (Eads, Miranda & Lignos 2015).
std::vector<Time> periods_around(Time period);
/// Geometric mean of the spectral accelerations at these periods, at least one.
Acceleration average_spectral_acceleration(const GroundMotion& motion, std::span<const Time> periods,
                                           double damping_ratio = 0.05);

/// Returns the motion with every acceleration multiplied so that the measure has the target value > 0. These throw
/// InputError if it is zero, or a parameter is outside its range.
GroundMotion scaled_to_pgv(const GroundMotion& motion, Speed target);
/// Scales the motion until its spectral acceleration at this period is `target`.
GroundMotion scaled_to_sa(const GroundMotion& motion, Time period, Acceleration target, double damping_ratio = 0.05);
/// Scales the motion until its average spectral acceleration over these periods is `target`.
GroundMotion scaled_to_average_sa(const GroundMotion& motion, std::span<const Time> periods, Acceleration target,
                                  double damping_ratio = 0.05);

/// Both components with one factor, so that the geometric mean of their measures has the target value.
PlanMotion scaled_to_pga(const PlanMotion& pair, Acceleration target);
/// Scales both components with one factor, so that the geometric mean of their PGV is `target`.
PlanMotion scaled_to_pgv(const PlanMotion& pair, Speed target);
/// Scales both components alike, until the geometric mean of their spectral accelerations at this period is `target`.
PlanMotion scaled_to_sa(const PlanMotion& pair, Time period, Acceleration target, double damping_ratio = 0.05);
/// Scales both components alike, until the geometric mean of their average spectral accelerations is `target`.
PlanMotion scaled_to_average_sa(const PlanMotion& pair, std::span<const Time> periods, Acceleration target,
                                double damping_ratio = 0.05);

}  // namespace moat
