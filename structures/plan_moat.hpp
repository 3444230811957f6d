// The walls around an isolated base in plan, and neighbours beside each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elements/corner_gap.hpp"
#include "elements/plan_spring.hpp"
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
  /// > 0 m, <= reach: the walls are the outline moved outwards by it. Leave it out where `walls` are given.
  Length clearance{};
  /// A polygon around the outline, counter-clockwise.
  PlanOutline walls{};
  Law law;                    ///< Its force.
  CornerFriction friction{};  ///< Along the walls.
  /// Whether the law is that of a corner or of a whole face.
  Share share = Share::per_corner;
  /// 0, or >= 3 points of every face that divide the law of the face.
  int points_per_face = 0;
  /// > 0 m: walls farther away from a corner are left out.
  Length reach = 1.0 * units::m;
  std::optional<FlexibleWall> wall{};  ///< Rigid without.
};

/// Two bodies beside each other, at any angle: corners of each hit edges of the other. Elements "<name> second edge 1
/// corner 3" (a corner of the first body), and "<name> first edge 2 corner 4".
template <ImpactLaw Law>
struct PlanNeighbours {
  std::string name = "neighbours";  ///< Unique in its model.
  /// Diaphragms with outlines.
  Required<DiaphragmId> first;
  Required<DiaphragmId> second;  ///< The other floor.
  Law law;                       ///< Its force.
  CornerFriction friction{};     ///< Along the walls.
  /// > 0 m: pairs farther apart are left out.
  Length reach = 1.0 * units::m;
};

/// The walls of a moat and the corners that face them. Throws InputError for a clearance that is not > 0 m or above the
/// reach, both or neither of clearance and walls, a diaphragm without outline, and as corners_facing_walls() does.
struct MoatLayout {
  PlanOutline walls;                  ///< As built.
  std::vector<FacingCorner> corners;  ///< Those that may meet an edge.
};
/// As MoatLayout says.
MoatLayout moat_layout(const Model& model, const std::string& name, DiaphragmId around, Length clearance,
                       const PlanOutline& walls, const Facing& facing);
/// Throws InputError for a diaphragm without outline, and as corners_facing_each_other() does.
std::vector<FacingCorner> neighbour_corners(const Model& model, const std::string& name, DiaphragmId first,
                                            DiaphragmId second, Length reach);
/// Adds a flexible wall that moves along the normal of an edge, outwards, and returns its node.
NodeId add_plan_wall(Model& model, const FlexibleWall& wall, const std::string& name, PlanVector normal);

/// Throws InputError as moat_layout(), the contacts and the walls do.
template <ImpactLaw Law>
void add(Model& model, const PlanMoat<Law>& moat) {
  const MoatLayout layout = moat_layout(model, moat.name, moat.around, moat.clearance, moat.walls,
                                        {moat.reach, moat.share, moat.points_per_face});
  const PlacedDiaphragm& base = model.diaphragm(moat.around);
  // Of a law that belongs to a whole face: the mass that meets it flat.
  const Mass of_face = (moat.share == Share::per_face || moat.points_per_face > 0 ? base.mass : 0.0) * units::kg;
  std::vector<NodeId> walls(layout.walls.size(), ground);
  const auto wall_name = [&](std::size_t edge) { return moat.name + " wall " + std::to_string(edge + 1); };
  const std::string base_name = base.name;
  for (const FacingCorner& each : layout.corners) {
    const bool of_base = each.of_first;
    if (of_base && moat.wall && walls[each.edge] == ground)
      walls[each.edge] =
          add_plan_wall(model, *moat.wall, wall_name(each.edge), turned_left(each.begin.si() - each.end.si()));
    const std::string edge_name = of_base ? wall_name(each.edge) : base_name + " edge " + std::to_string(each.edge + 1);
    const NodeId corner_body = of_base ? moat.around.value().x : ground;
    add(model, CornerGap<Law>{
                   .name = of_base ? edge_name + " " + each.corner : moat.name + " " + each.corner + " " + edge_name,
                   .place = moat.name,
                   .corner = PlanPoint{corner_body, each.at},
                   .edge_of = of_base ? walls[each.edge] : moat.around.value().x,
                   .edge_begin = each.begin,
                   .edge_end = each.end,
                   .law = moat.law,
                   .friction = moat.friction,
                   .share = each.share,
                   .effective_mass = of_face,
                   .corner_name = (of_base ? base_name : moat.name) + " " + each.corner,
                   .edge_name = edge_name});
  }
}

/// Throws InputError as neighbour_corners() and the contacts do.
template <ImpactLaw Law>
void add(Model& model, const PlanNeighbours<Law>& neighbours) {
  const std::string first = model.diaphragm(neighbours.first).name, second = model.diaphragm(neighbours.second).name;
  for (const FacingCorner& each :
       neighbour_corners(model, neighbours.name, neighbours.first, neighbours.second, neighbours.reach)) {
    const std::string &own = each.of_first ? first : second, &other = each.of_first ? second : first;
    const std::string edge = other + " edge " + std::to_string(each.edge + 1);
    const DiaphragmId corner_body = each.of_first ? neighbours.first : neighbours.second,
                      edge_body = each.of_first ? neighbours.second : neighbours.first;
    add(model, CornerGap<Law>{.name = neighbours.name + " " + own + " " + each.corner + " " + edge,
                              .place = neighbours.name,
                              .corner = PlanPoint{corner_body.x, each.at},
                              .edge_of = edge_body.x,
                              .edge_begin = each.begin,
                              .edge_end = each.end,
                              .law = neighbours.law,
                              .friction = neighbours.friction,
                              .corner_name = own + " " + each.corner,
                              .edge_name = edge});
  }
}

}  // namespace moat
