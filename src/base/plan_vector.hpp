// Vectors and matrices of two components, in plan.
#pragma once

#include <cmath>

namespace moat {

/// Two components of a quantity in plan: x to the right, y up.
struct PlanVector {
  double x = 0.0, y = 0.0;  ///< along x and y

  /// Adds the other.
  constexpr PlanVector& operator+=(PlanVector other) {
    x += other.x;
    y += other.y;
    return *this;
  }
  friend constexpr PlanVector operator+(PlanVector a, PlanVector b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr PlanVector operator-(PlanVector a, PlanVector b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr PlanVector operator-(PlanVector a) { return {-a.x, -a.y}; }
  friend constexpr PlanVector operator*(double factor, PlanVector a) { return {factor * a.x, factor * a.y}; }
  friend constexpr PlanVector operator/(PlanVector a, double divisor) { return {a.x / divisor, a.y / divisor}; }
  friend constexpr bool operator==(PlanVector, PlanVector) = default;
};

/// The scalar product.
[[nodiscard]] constexpr double dot(PlanVector a, PlanVector b) { return a.x * b.x + a.y * b.y; }
/// The product, for code that serves quantities of one component and of two.
[[nodiscard]] constexpr double dot(double a, double b) { return a * b; }
/// Positive if b lies counter-clockwise of a.
[[nodiscard]] constexpr double cross(PlanVector a, PlanVector b) { return a.x * b.y - a.y * b.x; }
/// sqrt(x^2 + y^2).
[[nodiscard]] inline double length(PlanVector a) { return std::hypot(a.x, a.y); }
/// By 90 degrees, counter-clockwise.
[[nodiscard]] constexpr PlanVector turned_left(PlanVector a) { return {-a.y, a.x}; }

/// The derivative of one plan vector by another: rows are components of the first.
struct PlanMatrix {
  double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;  ///< first index: of the result; second: of the argument

  /// factor times identity.
  [[nodiscard]] static constexpr PlanMatrix diagonal(double factor) { return {factor, 0.0, 0.0, factor}; }
  /// The matrix whose rows are those of a column a times a row b.
  [[nodiscard]] static constexpr PlanMatrix product(PlanVector a, PlanVector b) {
    return {a.x * b.x, a.x * b.y, a.y * b.x, a.y * b.y};
  }
  friend constexpr PlanMatrix operator+(PlanMatrix a, PlanMatrix b) {
    return {a.xx + b.xx, a.xy + b.xy, a.yx + b.yx, a.yy + b.yy};
  }
  friend constexpr PlanMatrix operator*(double factor, PlanMatrix a) {
    return {factor * a.xx, factor * a.xy, factor * a.yx, factor * a.yy};
  }
  friend constexpr PlanVector operator*(PlanMatrix a, PlanVector b) {
    return {a.xx * b.x + a.xy * b.y, a.yx * b.x + a.yy * b.y};
  }
  friend constexpr PlanMatrix operator*(PlanMatrix a, PlanMatrix b) {
    return {a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx, a.yx * b.xy + a.yy * b.yy};
  }
  friend constexpr bool operator==(PlanMatrix, PlanMatrix) = default;
};

}  // namespace moat
