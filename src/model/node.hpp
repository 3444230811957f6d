// A point with mass that moves along the direction of shaking, and points between two.
#pragma once

#include <compare>
#include <concepts>
#include <string>

#include "base/copyable_pointer.hpp"
#include "base/plan_vector.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
#include "base/units.hpp"
#include "model/couplings.hpp"

namespace moat {

/// Names a node of a model. Made by add(model, Node{...}); only `ground` exists beforehand.
struct NodeId {
  static constexpr int unspecified = -2;          ///< Index of a node that was not given.
  static constexpr int first_follower = 1 << 28;  ///< Followers count from here (model/body.hpp).
  int index = unspecified;                        ///< In its model; -1: the ground.

  [[nodiscard]] constexpr bool specified() const { return index != unspecified; }       ///< Whether add() made it.
  [[nodiscard]] constexpr bool is_follower() const { return index >= first_follower; }  ///< No degree of freedom.
  friend constexpr auto operator<=>(NodeId, NodeId) = default;
};

/// The ground below the structure. It moves with the ground motion; displacements are relative to it.
inline constexpr NodeId ground{ground_index};

/// A node: one horizontal degree of freedom with mass.
///
///     const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne});
///
/// Displacement is positive to the right (+x), relative to the ground.
struct Node {
  /// Unique in its model; used in every table, file and message.
  std::string name;
  /// > 0 kg: every degree of freedom needs mass.
  Required<Mass> mass;
  /// At time zero, relative to the ground.
  Length initial_displacement{};
  /// At time zero, relative to the ground.
  Speed initial_velocity{};
  /// Whether nothing need hold it: an analysis refuses a body that is held by gaps alone, unless one of its nodes is
  /// free or moves at the start.
  bool free = false;
  /// Position along the shaking, height, and half the width of the floor: for drawings, and the height for Neighbours.
  Length x{};
  Length height{};                     ///< Above the ground.
  Length half_width = 5.0 * units::m;  ///< For drawings.
  /// For models in plan only, where it must be given: the direction of its motion, of length 1. A node on a line moves
  /// along the shaking.
  CopyablePointer<const PlanVector> direction{};
};

/// A point on the straight line between two nodes, usually on a column between two floors:
///
///     u(point) = (1 - share) u(node) + share u(other)
///
/// A node alone is such a point with share 0. NodeId converts to a point, so that either can be given.
struct MemberPoint {
  NodeId node{};       ///< where share is 0
  NodeId other{};      ///< where share is 1
  double share = 0.0;  ///< 0 <= share < 1

  MemberPoint() = default;
  /// A node alone, or a floor on a line.
  template <std::convertible_to<NodeId> Place>
  MemberPoint(const Place& at) : node(at), other{node} {}
  /// 0 <= share_of_upper < 1.
  MemberPoint(NodeId lower, NodeId upper, double share_of_upper) : node{lower}, other{upper}, share{share_of_upper} {}

  /// Whether the point is a node.
  [[nodiscard]] bool is_node() const { return share == 0.0; }

  friend bool operator==(const MemberPoint&, const MemberPoint&) = default;
};

}  // namespace moat
