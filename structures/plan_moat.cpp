#include "structures/plan_moat.hpp"

#include "materials/viscous.hpp"

namespace moat {
namespace {

// Adds a flexible wall that moves along the normal of an edge, outwards, and returns its node.
NodeId add_plan_wall(Model& model, const FlexibleWall& wall, const std::string& name, PlanVector normal) {
  const Check check{"FlexibleWall", name};
  wall.check(check);
  check.that(!wall.backfill, "backfill is given, which walls in plan do not have.",
             "Leave it out, and give the wall the stiffness of the soil with its own.");
  const PlanVector direction = normal / length(normal);
  const NodeId node = add(model, Node{.name = name, .mass = wall.mass, .direction = direction});
  wall.acting_law().add_in_plan(model, name, node, direction);
  if (wall.dashpot().si() > 0.0)
    add(model, PlanSpring<Viscous>{.name = name + " damping",
                                   .lower = PlanPoint{ground, {}},
                                   .upper = PlanPoint{node, {}},
                                   .direction = direction,
                                   .law = {.damping = wall.dashpot()},
                                   .deformation_quantity = "",
                                   .force_quantity = ""});
  return node;
}

}  // namespace

std::vector<CornerPlace> moat_pairs(Model& model, const std::string& name, DiaphragmId around,
                                    std::optional<Length> clearance, const PlanOutline& walls, const Facing& facing,
                                    const std::optional<FlexibleWall>& wall) {
  const Check check{"PlanMoat", name};
  check.that(!name.empty(), "a moat has no name.", "Give .name, or leave it out: \"moat\".");
  const PlacedDiaphragm& base = model.diaphragm(around);
  check.that(!base.outline.empty(), "the diaphragm \"" + base.name + "\" has no outline.",
             "Give Diaphragm::outline: its corners hit the walls.");
  if (!walls.empty()) {
    check.that(!clearance, "both .clearance and .walls are given.", "Leave one of them out.");
  } else {
    check.that(clearance.has_value(), "clearance is not given.", "Give the free distance at rest, or .walls.");
    check.not_negative("clearance", *clearance, "Give the free distance at rest, 0 m for wall to wall.");
    check.that(*clearance <= facing.reach, "clearance", clearance->si(), "m",
               "at most the reach, " + to_text(facing.reach.si()) + " m",
               "No corner would meet a wall: give a longer .reach.");
  }
  const std::string base_name = base.name;
  const PlanOutline edges = walls.empty() ? offset_outwards(base.outline, *clearance) : walls;
  // A law that belongs to a whole face gets the mass that meets it flat.
  const bool of_face = facing.share == Share::per_face || facing.points_per_face > 0;
  const Mass effective_mass = of_face ? base.mass * units::kg : Mass{};

  std::vector<CornerPlace> pairs;
  std::vector<NodeId> wall_nodes(edges.size(), ground);
  for (const FacingCorner& each : corners_facing_walls(check, base.outline, edges, facing, "\"" + base_name + "\"")) {
    const std::string number = std::to_string(each.edge + 1), wall_name = name + " wall " + number,
                      edge_name = each.of_first ? wall_name : base_name + " edge " + number;
    NodeId& wall_node = wall_nodes[each.edge];
    if (each.of_first && wall && wall_node == ground)
      wall_node = add_plan_wall(model, *wall, wall_name, turned_left(each.begin.si() - each.end.si()));
    pairs.push_back({.name = each.of_first ? edge_name + " " + each.corner : name + " " + each.corner + " " + edge_name,
                     .place = name,
                     .corner = PlanPoint{each.of_first ? around.x : ground, each.at},
                     .edge_of = each.of_first ? wall_node : around.x,
                     .edge_begin = each.begin,
                     .edge_end = each.end,
                     .share = each.share,
                     .effective_mass = effective_mass,
                     .corner_name = (each.of_first ? base_name : name) + " " + each.corner,
                     .edge_name = edge_name});
  }
  return pairs;
}

}  // namespace moat
