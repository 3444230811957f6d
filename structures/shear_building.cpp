#include "structures/shear_building.hpp"

#include "base/check.hpp"
#include "elements/shear_spring.hpp"
#include "elements/viscous_damper.hpp"

namespace moat {
namespace {

void check_parameters(const ShearBuilding& building) {
  const Check check{"ShearBuilding", building.name};
  check.that(building.storeys >= 1, "storeys", building.storeys, "", ">= 1");
  check.positive("floor_mass", building.floor_mass);
  check.positive("storey_stiffness", building.storey_stiffness);
  check.positive("storey_height", building.storey_height);
  check.positive("half_width", building.half_width);
  if (building.isolation) {
    check.positive("base_mass", building.base_mass, "An isolated building needs the mass of its base floor.");
    check.that(building.isolation->lower == ground, "isolation.lower is given.",
               "Leave it out: the bearings stand on the ground.");
    check.that(!building.isolation->upper.specified(), "isolation.upper is given.",
               "Leave it out: the bearings carry the base.");
  } else {
    check.that(building.base_mass == Mass{}, "base_mass", building.base_mass.si(), "kg",
               "left out without isolation: the ground is the base", "Give .isolation, or leave out .base_mass.");
  }
}

// Two buildings without names are a likely slip; a message about a node that the script never made would puzzle.
void require_new_name(const Model& model, const ShearBuilding& building) {
  const std::string floor = building.name.empty() ? "floor 1" : building.name + " floor 1";
  if (!model.has_node(floor)) return;
  Check{"ShearBuilding", building.name}.that(false, "the model has a node \"" + floor + "\" already.",
                                             "Give every building its own .name.");
}

}  // namespace

BuildingNodes add(Model& model, const ShearBuilding& building) {
  check_parameters(building);
  require_new_name(model, building);
  const auto named = [&](std::string part) { return building.name.empty() ? part : building.name + " " + part; };
  const auto node = [&](const std::string& part, Mass mass, int level) {
    return add(model, Node{.name = named(part),
                           .mass = mass,
                           .x = building.x,
                           .height = level * building.storey_height,
                           .half_width = building.half_width});
  };

  BuildingNodes nodes{.base = building.isolation ? node("base", building.base_mass, 0) : ground, .floors = {}};
  for (int floor = 1; floor <= building.storeys; ++floor)
    nodes.floors.push_back(node("floor " + std::to_string(floor), building.floor_mass, floor));

  const std::vector<Mass> masses(nodes.floors.size(), building.floor_mass);
  const std::vector<Stiffness> stiffnesses(nodes.floors.size(), building.storey_stiffness);
  const RayleighFactors rayleigh = rayleigh_factors_of_chain(building.damping.ratio, masses, stiffnesses);

  NodeId below = nodes.base;
  for (int storey = 1; storey <= building.storeys; ++storey) {
    const NodeId above = nodes.floors[static_cast<std::size_t>(storey - 1)];
    const std::string number = std::to_string(storey);
    add(model,
        ShearSpring{
            .name = named("storey " + number), .lower = below, .upper = above, .stiffness = building.storey_stiffness});
    if (rayleigh.stiffness_factor > 0.0)
      add(model, ViscousDamper{.name = named("storey " + number + " damping"),
                               .lower = below,
                               .upper = above,
                               .damping = rayleigh.stiffness_factor * units::s * building.storey_stiffness.value()});
    if (rayleigh.mass_factor > 0.0)
      add(model, ViscousDamper{.name = named("floor " + number + " damping"),
                               .lower = nodes.base,
                               .upper = above,
                               .damping = rayleigh.mass_factor / units::s * building.floor_mass.value()});
    below = above;
  }

  if (building.isolation) {
    LeadRubberBearing bearing = *building.isolation;
    bearing.name = named(bearing.name);
    bearing.lower = ground;
    bearing.upper = nodes.base;
    add(model, bearing);
  }

  std::vector<NodeId> all = nodes.floors;
  if (building.isolation) all.insert(all.begin(), nodes.base);
  add(model, BaseShear{.where = named("base"), .nodes = std::move(all)});
  return nodes;
}

}  // namespace moat
