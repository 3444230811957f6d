// A point in plan, fixed to a body.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "model/model.hpp"

namespace moat {

/// A point of a diaphragm, of a wall that moves along its own direction, or of the ground; `at` is its position at
/// rest, in coordinates of the whole model.
///
///     PlanPoint{base, {10 * m, 6 * m}}    PlanPoint{ground, {10 * m, 6 * m}}
///
/// Or a point of a column between two of them, at the same position in plan:
///
///     PlanPoint{floor_1, {10 * m, 6 * m}, floor_2, 0.4}    u = 0.6 u(floor 1 at this position) + 0.4 u(floor 2)
struct PlanPoint {
  /// A diaphragm stands for itself; a node is a wall (Node::direction), or `ground`.
  Required<NodeId> of;
  PlanPosition at{};   ///< m, at rest
  NodeId other{};      ///< where share would be 1; left out for a point of one body
  double share = 0.0;  ///< 0 <= share < 1, of `other` in the displacement

  /// Whether it is a point of one body.
  [[nodiscard]] bool is_on_body() const { return share == 0.0; }
};

/// The shares of up to three degrees of freedom in the displacement of a point of a body along a direction.
struct PlanRow {
  std::array<NodeId, 3> node{ground, ground, ground};  ///< `ground` where there is none
  std::array<double, 3> weight{};                      ///< of each
};

/// `direction` has length 1, or any other: displacements scale with it. Zero weights for the ground.
PlanRow row_of(const Model& model, NodeId body, PlanPosition at, PlanVector direction);

/// Throws InputError unless the point is on a diaphragm or a wall of this model, on the ground, or between two of
/// these, finite, and its share from 0 to below 1.
void check_point(const Model& model, std::string_view kind, const std::string& name, std::string_view field,
                 const PlanPoint& point);
/// check_point() of both, and that they are on different bodies: none of either is one of the other.
Check check_points(const Model& model, std::string_view kind, const std::string& name, std::string_view first_field,
                   const PlanPoint& first, std::string_view second_field, const PlanPoint& second);
/// The direction with length 1. Throws InputError for a vector without length.
PlanVector unit_direction(const Check& check, std::string_view field, PlanVector direction);
/// Adds the places to details of an element; `direction` has length 1, or is zero for one that acts in both directions.
std::shared_ptr<const ElementDetails> plan_details(const PlanPoint& first, const PlanPoint& second,
                                                   PlanVector direction, ElementDetails details = {});

}  // namespace moat
