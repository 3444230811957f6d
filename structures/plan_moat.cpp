#include "structures/plan_moat.hpp"

#include "materials/viscous.hpp"

namespace moat {
namespace {

const PlacedDiaphragm& with_outline(const Model& model, const Check& check, DiaphragmId id) {
  const PlacedDiaphragm& diaphragm = model.diaphragm(id);
  check.that(!diaphragm.outline.empty(), "the diaphragm \"" + diaphragm.name + "\" has no outline.",
             "Give Diaphragm::outline: its corners hit the walls.");
  return diaphragm;
}

}  // namespace

MoatLayout moat_layout(const Model& model, const std::string& name, DiaphragmId around, Length clearance,
                       const PlanOutline& walls, const Facing& facing) {
  const Check check{"PlanMoat", name};
  check.that(!name.empty(), "a moat has no name.", "Give .name, or leave it out: \"moat\".");
  const PlacedDiaphragm& base = with_outline(model, check, around);
  if (!walls.empty()) {
    check.that(clearance == Length{}, "both .clearance and .walls are given.", "Leave one of them out.");
  } else {
    check.positive("clearance", clearance, "Give the free distance at rest, or .walls.");
    check.that(clearance <= facing.reach, "clearance", clearance.si(), "m",
               "at most the reach, " + to_text(facing.reach.si()) + " m",
               "No corner would meet a wall: give a longer .reach.");
  }
  MoatLayout layout{walls.empty() ? offset_outwards(base.outline, clearance) : walls, {}};
  layout.corners = corners_facing_walls(check, base.outline, layout.walls, facing, "\"" + base.name + "\"");
  return layout;
}

std::vector<FacingCorner> neighbour_corners(const Model& model, const std::string& name, DiaphragmId first,
                                            DiaphragmId second, Length reach) {
  const Check check{"PlanNeighbours", name};
  check.that(!name.empty(), "neighbours have no name.", "Give .name, or leave it out: \"neighbours\".");
  const PlacedDiaphragm &a = with_outline(model, check, first), &b = with_outline(model, check, second);
  return corners_facing_each_other(check, a.outline, b.outline, reach, "\"" + a.name + "\" and \"" + b.name + "\"");
}

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

}  // namespace moat
