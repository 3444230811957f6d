#include "structures/moat.hpp"

#include "elements/link_block.hpp"
#include "elements/spring.hpp"
#include "elements/viscous_damper.hpp"
#include "materials/linear.hpp"
#include "materials/located_bilinear.hpp"

namespace moat {
namespace {

// The spring and dashpot between the ground and the mass.
void add_base(Model& model, const FlexibleWall& wall, const std::string& name, NodeId node) {
  const auto add_spring = [&](const auto& law) {
    add(model, Spring<std::remove_cvref_t<decltype(law)>>{.name = name,
                                                          .lower = ground,
                                                          .upper = node,
                                                          .law = law,
                                                          .deformation_quantity = "wall_deformation",
                                                          .force_quantity = "wall_force"});
  };
  if (wall.yield_force == Force{}) {
    add_spring(Linear{.stiffness = wall.stiffness, .damping = wall.damping});
    return;
  }
  add_spring(LocatedBilinear{{.yield_force = wall.yield_force,
                              .yield_displacement = wall.yield_force / wall.stiffness.value(),
                              .post_yield_stiffness = wall.hardening_ratio * wall.stiffness.value()}});
  if (wall.damping.si() > 0.0)
    add(model, ViscousDamper{.name = name + " damping", .lower = ground, .upper = node, .damping = wall.damping});
}

// Soil resists where the wall moves away from the building. Its deformation counts towards the soil.
void add_backfill(Model& model, const HyperbolicBackfill& soil, const std::string& wall, NodeId node, bool on_left) {
  const std::string name = wall + " backfill";
  soil.check(Check{"HyperbolicBackfill", name});
  model.register_element("HyperbolicBackfill", name);
  model.block<LinkBlock<HyperbolicBackfill>>().add({.name = name,
                                                    .first = on_left ? node : ground,
                                                    .second = on_left ? ground : node,
                                                    .deformation_quantity = "backfill_deformation",
                                                    .force_quantity = "backfill_force"},
                                                   soil);
}

}  // namespace

FlexibleWall FlexibleWall::from_geometry(const WallGeometry& geometry) {
  const Check check{"WallGeometry", ""};
  check.positive("height", geometry.height);
  check.positive("thickness", geometry.thickness);
  check.positive("width", geometry.width);
  check.positive("youngs_modulus", geometry.youngs_modulus.si(), "Pa");
  check.positive("density", geometry.density.si(), "kg/m^3");
  check.above_up_to("cracked_share", geometry.cracked_share, 0.0, 1.0, "1", "0.3 to 0.5 where concrete has cracked.");
  check.not_negative("base_rotation", geometry.base_rotation.si(), "N m");
  check.not_negative("yield_moment", geometry.yield_moment.si(), "N m");
  const double h = geometry.height.si(), t = geometry.thickness.si(), b = geometry.width.si();
  const double inertia = geometry.cracked_share * b * t * t * t / 12.0;
  const double bending = h * h * h / (3.0 * geometry.youngs_modulus.si() * inertia);
  const bool turns = geometry.base_rotation.si() > 0.0;
  const double rotation = turns ? h * h / geometry.base_rotation.si() : 0.0;
  constexpr double of_cantilever = 33.0 / 140.0, of_turning_wall = 1.0 / 3.0;
  return {
      .mass = (rotation > bending ? of_turning_wall : of_cantilever) * geometry.density.si() * b * t * h * units::kg,
      .stiffness = 1.0 / (bending + rotation) * units::N / units::m,
      .yield_force = geometry.yield_moment / geometry.height.value()};
}

NodeId add_wall(Model& model, const FlexibleWall& wall, const std::string& name, NodeId around, double offset) {
  const Check check{"FlexibleWall", name};
  check.positive("mass", wall.mass);
  check.positive("stiffness", wall.stiffness);
  check.not_negative("damping", wall.damping);
  check.not_negative("yield_force", wall.yield_force);
  check.that(wall.hardening_ratio >= 0.0 && wall.hardening_ratio < 1.0, "hardening_ratio", wall.hardening_ratio, "1",
             ">= 0 and < 1");
  const Node& base = model.node(around);
  // For drawings only: a wall half a metre thick whose face is the clearance away from the floor's edge.
  const Length half_width = 0.25 * units::m;
  const Length distance = offset * units::m + (offset < 0.0 ? -1.0 : 1.0) * (base.half_width + half_width);
  const NodeId node = add(
      model,
      Node{.name = name, .mass = wall.mass, .x = base.x + distance, .height = base.height, .half_width = half_width});
  add_base(model, wall, name, node);
  if (wall.backfill) add_backfill(model, *wall.backfill, name, node, offset < 0.0);
  return node;
}

}  // namespace moat
