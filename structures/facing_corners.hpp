// Which corners of a body can hit which edges of another.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "model/plan_outline.hpp"

namespace moat {

/// A point of one body and the edge of another that it can hit.
struct FacingCorner {
  bool of_first = true;  ///< the point belongs to the first body and the edge to the second; else the other way round
  PlanPosition at;       ///< at rest
  std::string corner;    ///< "corner 2", or "point 3 of edge 1" between two corners
  std::size_t edge = 0;  ///< counted from 0
  PlanPosition begin, end;  ///< of the edge; the point is on the left of the way from begin to end
  double share = 1.0;       ///< of the law's force
};

/// How the law of a contact is meant.
enum class Share {
  per_corner,  ///< every corner has the whole law
  per_face,    ///< the law is that of a whole face: half of it acts at each of the two corners
};

/// How corners and edges are paired.
struct Facing {
  Length reach = 1.0 * units::m;    ///< edges farther away than this are left out
  Share share = Share::per_corner;  ///< whole laws, or shares of one
  /// 0, or >= 3: points along every face that is parallel to the edge; they divide the law of the face.
  int points_per_face = 0;
};

/// Corners of an outline inside walls, and corners of the walls that point inwards; each with the edges that it faces:
/// both sides of the corner lead away from the edge, or along it. Throws InputError if the outline
/// crosses the walls, if more than two corners face a wall that has its law per face, and if no corner is
/// within reach of a wall. `inner` and `outer` name both.
std::vector<FacingCorner> corners_facing_walls(const Check& check, const PlanOutline& outline, const PlanOutline& walls,
                                               const Facing& facing, const std::string& inner);

/// Corners of two bodies beside each other. Where two corners of parallel faces stand opposite each other, the corner
/// of the shorter face counts; where the faces are equal, the corner of the first body. Throws InputError if the
/// outlines overlap.
std::vector<FacingCorner> corners_facing_each_other(const Check& check, const PlanOutline& first,
                                                    const PlanOutline& second, Length reach, const std::string& names);

/// Columns of the first body that can hit edges of a floor beside it: within reach of the edge, and not more than 1 m
/// inside the outline around them, so that the row behind them is left out. Without columns the corners of that outline
/// stand for them. Throws InputError for one that is inside the floor; `storey` and `floor_name` name both.
std::vector<FacingCorner> columns_facing_floor(const Check& check, const std::vector<PlanPosition>& columns,
                                               const PlanOutline& around, const PlanOutline& floor, Length reach,
                                               const std::string& storey, const std::string& floor_name);

}  // namespace moat
