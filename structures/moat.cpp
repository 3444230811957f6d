#include "structures/moat.hpp"

namespace moat {

NodeId add_wall(Model& model, const FlexibleWall& wall, const std::string& name, NodeId around, double offset) {
  const Check check{"FlexibleWall", name};
  check.positive("mass", wall.mass);
  check.positive("stiffness", wall.stiffness);
  check.not_negative("damping", wall.damping);
  const Node& base = model.node(around);
  // For drawings only: a wall half a metre thick whose face is the clearance away from the floor's edge.
  const Length half_width = 0.25 * units::m;
  const Length distance = offset * units::m + (offset < 0.0 ? -1.0 : 1.0) * (base.half_width + half_width);
  const NodeId node = add(
      model,
      Node{.name = name, .mass = wall.mass, .x = base.x + distance, .height = base.height, .half_width = half_width});
  add(model, Spring<Linear>{.name = name,
                            .lower = ground,
                            .upper = node,
                            .law = {.stiffness = wall.stiffness, .damping = wall.damping},
                            .deformation_quantity = "wall_deformation",
                            .force_quantity = "wall_force"});
  return node;
}

}  // namespace moat
