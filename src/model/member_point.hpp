// A point between two nodes.
#pragma once

#include "model/node.hpp"

namespace moat {

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
  /// A node alone.
  MemberPoint(NodeId at) : node{at}, other{at} {}
  /// 0 <= share_of_upper < 1.
  MemberPoint(NodeId lower, NodeId upper, double share_of_upper) : node{lower}, other{upper}, share{share_of_upper} {}

  /// Whether the point is a node.
  [[nodiscard]] bool is_node() const { return share == 0.0; }

  friend bool operator==(const MemberPoint&, const MemberPoint&) = default;
};

/// The ends of an element that is attached between nodes, and where it is drawn.
struct MemberEnds {
  MemberPoint first, second;  ///< as ElementInfo::first and second
  double height = 0.0;        ///< m, of drawings

  friend bool operator==(const MemberEnds&, const MemberEnds&) = default;
};

}  // namespace moat
