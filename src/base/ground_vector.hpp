// Vectors of the ground.
#pragma once

#include <cmath>

#include "base/plan_vector.hpp"

namespace moat {

/// The three components of a quantity of the ground: x to the right, y up in plan, z upwards.
struct GroundVector {
  double x = 0.0, y = 0.0, z = 0.0;  ///< along x, y and z

  /// The components in plan.
  [[nodiscard]] constexpr PlanVector horizontal() const { return {x, y}; }

  friend constexpr GroundVector operator+(GroundVector a, GroundVector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr GroundVector operator-(GroundVector a, GroundVector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr GroundVector operator*(double factor, GroundVector a) {
    return {factor * a.x, factor * a.y, factor * a.z};
  }
  friend constexpr bool operator==(GroundVector, GroundVector) = default;
};

/// The scalar product.
[[nodiscard]] constexpr double dot(GroundVector a, GroundVector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
/// sqrt(x^2 + y^2 + z^2).
[[nodiscard]] inline double length(GroundVector a) { return std::hypot(a.x, a.y, a.z); }

/// One column of numbers for each component of the ground, with a row per degree of freedom; others own them.
struct GroundColumns {
  const double *x, *y, *z;  ///< one row per degree of freedom

  /// The row of a degree of freedom times a vector of the ground.
  [[nodiscard]] double times(GroundVector vector, int row) const {
    return x[row] * vector.x + y[row] * vector.y + z[row] * vector.z;
  }
};

}  // namespace moat
