// A corner and the edge that it may touch.
#pragma once

#include <algorithm>
#include <cmath>

#include "elements/block/corner_grip.hpp"
#include "elements/block/plan_ends.hpp"

namespace moat {

/// A distance and its rate.
struct CornerDistance {
  double value = 0.0, rate = 0.0;  ///< m, m/s
};

/// A corner and its edge, as the ends of a contact along the normal n (model/element_details.hpp). The edge reaches
/// from `edge_begin` to `edge_end` > edge_begin along the tangent t, from the corner at rest, m.
struct CornerAndEdge {
  using Vector = double;  ///< as NodePair
  using Matrix = double;  ///< as NodePair

  PlanEnds ends;                            ///< along n and t, of the corner relative to the edge
  ContactFriction friction;                 ///< along the edge
  double edge_begin = 0.0, edge_end = 0.0;  ///< along t, m
  double normal_mass = 0.0;                 ///< effective, kg
  double tangential_mass = 0.0;             ///< effective, kg

  /// Returns the margin of a corner in contact at this place along t, m: > 0 while it is beside the edge, or past an
  /// end by less than 1 % of the edge's length.
  [[nodiscard]] double margin_at_ends(double path) const {
    const double beyond = std::max(path - edge_end, edge_begin - path);
    return 0.01 * (edge_end - edge_begin) - beyond;
  }

  /// Returns the distance of an open corner from its edge, from that along the normal and the place along the tangent.
  [[nodiscard]] CornerDistance distance(CornerDistance gap, double path, double path_rate) const {
    const double past_end = path - edge_end, before_begin = edge_begin - path;
    const double beside = std::max(past_end, before_begin);
    // An open corner behind the line of its edge has passed an end: its distance is positive there too.
    const double apart = std::abs(gap.value), apart_rate = gap.value < 0.0 ? -gap.rate : gap.rate;
    if (beside <= 0.0) return {apart, apart_rate};
    const double value = std::hypot(apart, beside);
    return {value, (apart * apart_rate + beside * (past_end > before_begin ? path_rate : -path_rate)) / value};
  }

  void add_couplings(Couplings& couplings) const { ends.add_couplings(couplings); }              ///< As NodePair.
  void put_ground_at(int) {}                                                                     ///< As WeightedEnds.
  [[nodiscard]] double difference(const double* v) const { return ends.along().difference(v); }  ///< Along n.
  void add_force(double force, double* forces) const { ends.along().add_force(force, forces); }  ///< Along n.

  /// Stands for NodePair::Slots in plan.
  struct Slots {
    PlanEnds::Slots both;  ///< along n and t

    /// Finds the places of the ends in the matrix.
    Slots(const CornerAndEdge& corner, const SparseMatrix& matrix) : both{corner.ends, matrix} {}
    /// Adds a stiffness along the normal, N/m.
    void add_stiffness(const CornerAndEdge& corner, double stiffness, double* values) const {
      both.add_stiffness(corner.ends, {stiffness, 0.0, 0.0, 0.0}, values);
    }
  };
};

}  // namespace moat
