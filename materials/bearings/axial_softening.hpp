// Rubber that softens under compression.
#pragma once

#include "base/plan_vector.hpp"
#include "materials/bearings/rubber_bearing.hpp"

namespace moat {

/// The post-yield stiffness of a rubber bearing under an axial force N, as a factor of that without it:
///
///     k_2/k_20 = max(0.01, 1 - (N/P_cr)^2) for N > 0, else 1,     P_cr = RubberBearing::critical_load(farthest)
///
/// `farthest` is the displacement with the smallest overlap of both ends so far: rubber does not recover. The formula
/// is that of LeadRubberX of OpenSees, after Kumar, Whittaker & Constantinou (2014).
struct AxialSoftening {
  double factor = 1.0;           ///< k_2/k_20
  double by_compression = 0.0;   ///< its derivative by N, 1/N
  PlanVector by_displacement{};  ///< its derivative by the farthest displacement, 1/m
  double critical_load = 0.0;    ///< P_cr, N
  PlanVector critical_slope{};   ///< its derivative by the farthest displacement, N/m

  /// compression: N, N; farthest: m.
  AxialSoftening(const RubberBearing& rubber, double compression, PlanVector farthest);
};

}  // namespace moat
