// The walls around an isolated base in plan.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elements/contact/corner_gap.hpp"
#include "elements/plan/plan_spring.hpp"
#include "structures/facing_corners.hpp"
#include "structures/moat.hpp"

namespace moat {

/// A moat in plan: walls around the outline of a base.
///
///     +------------------------+  wall 3      Corners of the base hit the walls, where the law acts along the normal
///     |  +------------------+  |              and Coulomb friction along the wall.
///     |  | base             |  | wall 2
///     |  +------------------+  |              Wall i leads from corner i of the walls to the next one,
///     +------------------------+              counter-clockwise.
///          wall 1
///
/// Every pair of a corner and a wall within reach is an element "<name> wall 2 corner 3"; their impact forces share the
/// place NAME. The walls are fixed to the ground, or nodes "NAME wall 2" that move along their normals on springs
/// where `wall` is given; then `wall_force` [N] and `wall_deformation` [m] are reported too, and friction acts against
/// the fixed ground.
template <ImpactLaw Law>
struct PlanMoat {
  std::string name = "moat";  ///< Unique in its model.
  /// A diaphragm with an outline.
  Required<DiaphragmId> around;
  /// >= 0 m, <= reach: the walls are the outline moved outwards by it. Leave it out where `walls` are given.
  std::optional<Length> clearance{};
  /// A polygon around the outline, counter-clockwise.
  PlanOutline walls{};
  Law law;                    ///< Gives the force from the indentation.
  CornerFriction friction{};  ///< Along the walls.
  /// Whether the law is that of a corner or of a whole face.
  Share share = Share::per_corner;
  /// 0, or >= 3 points of every face that divide the law of the face.
  int points_per_face = 0;
  /// > 0 m: walls farther away from a corner are left out.
  Length reach = 1.0 * units::m;
  std::optional<FlexibleWall> wall{};  ///< The wall is rigid if left out.
};

/// The pairs of a moat; adds its walls where they are flexible. Throws InputError for a clearance that is < 0 m or
/// above the reach, both or neither of clearance and walls, a diaphragm without outline, and as corners_facing_walls().
std::vector<CornerPlace> moat_pairs(Model& model, const std::string& name, DiaphragmId around,
                                    std::optional<Length> clearance, const PlanOutline& walls, const Facing& facing,
                                    const std::optional<FlexibleWall>& wall);

/// Throws InputError as moat_pairs(), the contacts and the walls do.
template <ImpactLaw Law>
void add(Model& model, const PlanMoat<Law>& moat) {
  const Facing facing{moat.reach, moat.share, moat.points_per_face};
  for (CornerPlace& pair : moat_pairs(model, moat.name, moat.around, moat.clearance, moat.walls, facing, moat.wall)) {
    pair.friction = moat.friction;
    add(model, pair, moat.law);
  }
}

}  // namespace moat
