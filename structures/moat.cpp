#include "structures/moat.hpp"

#include "elements/line/viscous_damper.hpp"
#include "materials/bilinear.hpp"
#include "materials/linear.hpp"

namespace moat {
namespace {

void change_soil(ElementBlock& block, std::size_t e, const ContactChange& change) {
  auto& soils = dynamic_cast<LinkBlock<HyperbolicBackfill>&>(block);
  HyperbolicBackfill soil = soils.laws()[e];
  soil.initial_stiffness = change.soil_factor * soil.initial_stiffness;
  soil.ultimate_force = change.soil_factor * soil.ultimate_force;
  soil.unloading_stiffness *= change.soil_factor;
  soils.replace(e, soils.info(e), soil);
}

// Soil resists where the wall moves away from the building. Its deformation counts towards the soil.
void add_backfill(Model& model, const HyperbolicBackfill& soil, const std::string& wall, NodeId node, bool on_left) {
  add_link(model, "HyperbolicBackfill",
           {.name = wall + " backfill",
            .first = on_left ? node : ground,
            .second = on_left ? ground : node,
            .deformation_quantity = "backfill_deformation",
            .force_quantity = "backfill_force",
            .details = std::make_shared<const ElementDetails>(
                ElementDetails{.changeable_contact = ChangeableContact{.change = change_soil}})},
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

void FlexibleWall::check(const Check& check) const {
  check.positive("mass", mass);
  if (law) {
    check.that(stiffness == Stiffness{}, "stiffness", stiffness.si(), "N/m", "left out where law is given",
               "Give one of both.");
    check.that(yield_force == Force{}, "yield_force", yield_force.si(), "N", "left out where law is given",
               "Give one of both.");
  } else {
    check.positive("stiffness", stiffness);
  }
  check.not_negative("damping", damping);
  check.not_negative("yield_force", yield_force);
  check.that(hardening_ratio >= 0.0 && hardening_ratio < 1.0, "hardening_ratio", hardening_ratio, "1", ">= 0 and < 1");
}

WallLaw FlexibleWall::acting_law() const {
  if (law) return *law;
  if (yield_force == Force{}) return Linear{.stiffness = stiffness, .damping = damping};
  return Bilinear{.yield_force = yield_force,
                  .yield_displacement = yield_force / stiffness,
                  .post_yield_stiffness = hardening_ratio * stiffness};
}

NodeId add_wall(Model& model, const FlexibleWall& wall, const std::string& name, NodeId around, Length offset) {
  wall.check(Check{"FlexibleWall", name});
  const Body& base = model.body(around);
  // For drawings only: a wall half a metre thick whose face is the clearance away from the floor's edge.
  const Length half_width = 0.25 * units::m;
  const Length distance = offset + (offset.si() < 0.0 ? -1.0 : 1.0) * (Length{base.half_width} + half_width);
  const NodeId node = add(model, Node{.name = name,
                                      .mass = wall.mass,
                                      .x = Length{base.x} + distance,
                                      .height = Length{base.height},
                                      .half_width = half_width});
  wall.acting_law().add_to(model, name, node);
  if (wall.dashpot().si() > 0.0)
    add(model, ViscousDamper{.name = name + " damping", .lower = ground, .upper = node, .damping = wall.dashpot()});
  if (wall.backfill) add_backfill(model, *wall.backfill, name, node, offset.si() < 0.0);
  return node;
}

std::vector<MoatGap> moat_gaps(Model& model, const std::string& name, NodeId around, Length clearance, Sides sides,
                               const std::optional<FlexibleWall>& wall) {
  const Check check{"Moat", name};
  check.that(!name.empty(), "a moat has no name.", "Give .name, or leave it out: \"moat\".");
  model.require_node(around, check, "around");
  const bool on_both = sides == Sides::both;
  std::vector<MoatGap> gaps;
  if (sides != Sides::right) {
    const std::string left = name + (on_both ? " left" : "");
    gaps.push_back({left, wall ? add_wall(model, *wall, left + " wall", around, -clearance) : ground, around});
  }
  if (sides != Sides::left) {
    const std::string right = name + (on_both ? " right" : "");
    gaps.push_back({right, around, wall ? add_wall(model, *wall, right + " wall", around, clearance) : ground});
  }
  return gaps;
}

}  // namespace moat
