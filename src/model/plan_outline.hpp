// Polygons in plan: floors, moats.
#pragma once

#include <cstddef>
#include <vector>

#include "base/check.hpp"
#include "base/places.hpp"
#include "base/plan_vector.hpp"
#include "base/quantity.hpp"
#include "base/units.hpp"

namespace moat {

/// Points of a plan that are nearer than this, m, are at the same place.
inline constexpr double same_place = 1e-9;

/// A point in plan, in coordinates of the whole model: x to the right, y up.
struct PlanPosition {
  /// Coordinates on the plan.
  Length x{}, y{};

  [[nodiscard]] constexpr PlanVector si() const { return {x.si(), y.si()}; }  ///< m
};

/// A polygon in plan without holes. Corners are counted from 1, counter-clockwise; edge i leads from corner i to the
/// next one.
///
///      4 +--------+ 3
///        |        |        y
///      1 +--------+ 2      ^-> x
struct PlanOutline {
  /// At least three, counter-clockwise, in coordinates of the whole model.
  Places<PlanPosition, corners_remedy> corners{};

  [[nodiscard]] bool empty() const { return corners.empty(); }       ///< Without corners.
  [[nodiscard]] std::size_t size() const { return corners.size(); }  ///< Number of corners.
  /// m; of corner i % size(), counted from 0.
  [[nodiscard]] PlanVector corner(std::size_t i) const { return corners[i % corners.size()].si(); }
  /// m^2, of the enclosed area.
  [[nodiscard]] double area() const;
  /// m; of the enclosed area.
  [[nodiscard]] PlanVector centroid() const;
  /// m^2: polar second moment of the area about its centroid, over the area. (Lx^2 + Ly^2)/12 for a rectangle.
  [[nodiscard]] double gyration_squared() const;
  /// Whether a point, m, is inside or on the border.
  [[nodiscard]] bool contains(PlanVector point) const;
  /// Throws InputError for fewer than three corners, a corner that is not finite or repeated, edges that cross, and
  /// corners in clockwise order.
  void check(const Check& check, std::string_view field) const;
};

/// Sides of these lengths along x and y, about `centre`.
[[nodiscard]] PlanOutline rectangle(Length x, Length y, PlanPosition centre = {});
/// Turned counter-clockwise about `centre`.
[[nodiscard]] PlanPosition turned(PlanPosition point, Angle angle, PlanPosition centre = {});
/// All corners turned so.
[[nodiscard]] PlanOutline turned(const PlanOutline& outline, Angle angle, PlanPosition centre = {});
/// All edges moved outwards by `distance`, or inwards by a negative one that is shorter than half of every edge.
[[nodiscard]] PlanOutline offset_outwards(const PlanOutline& outline, Length distance);

}  // namespace moat
