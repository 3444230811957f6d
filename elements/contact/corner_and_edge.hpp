// A corner and the edge that it may touch.
#pragma once

#include <algorithm>

#include "elements/contact/corner_grip.hpp"
#include "elements/plan/plan_ends.hpp"
#include "model/plan_contacts.hpp"

namespace moat {

/// A corner and its edge. The edge reaches from `edge_begin` to `edge_end` > edge_begin along the tangent t, from the
/// corner at rest, m.
struct CornerAndEdge {
  CornerPair pair;                                  ///< names and places
  PlanEndsBothWays ends;                            ///< along n and t, of the corner relative to the edge
  ContactFriction friction;                         ///< along the edge
  double edge_begin = 0.0, edge_end = 0.0;          ///< along t, m
  double normal_mass = 0.0, tangential_mass = 0.0;  ///< effective, kg
  double cross_mobility = 0.0;                      ///< of one direction under a force along the other, 1/kg

  /// Returns the margin of a corner in contact at this place along t, m: > 0 while it is beside the edge, or past an
  /// end by less than 1 % of the edge's length.
  [[nodiscard]] double margin_at_ends(double path) const {
    const double beyond = std::max(path - edge_end, edge_begin - path);
    return 0.01 * (edge_end - edge_begin) - beyond;
  }
};

}  // namespace moat
