// A corner of one body and an edge of another, in plan.
#pragma once

#include <string>

#include "base/plan_vector.hpp"

namespace moat {

/// A corner of one body and an edge of another.
///
///        edge  |
///              |     normal: from the body of the corner to the other body
///     corner > |-->  tangent: the normal turned by +90 degrees
///              |
struct CornerPair {
  std::string corner, edge;             ///< names, for tables: "base corner 2", "moat wall 3"
  PlanVector position{};                ///< of the corner at rest, m
  PlanVector edge_begin{}, edge_end{};  ///< at rest, m; the corner is on the left of the way between them
  PlanVector normal{};                  ///< of length 1
  double distance_at_rest = 0.0;        ///< of the corner from the edge, m; from the nearer end where it is beside it
  /// Whether a corner that slides could be pressed into its edge without an end: 1/m_n <= mu |m_nt|, with the mobility
  /// m_nt of normal motion under a force along the tangent. No law can separate them then.
  bool may_jam = false;
};

}  // namespace moat
