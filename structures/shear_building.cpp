#include "structures/shear_building.hpp"

#include <vector>

#include "base/check.hpp"
#include "elements/shear_spring.hpp"
#include "elements/viscous_damper.hpp"

namespace moat {
namespace {

void check_parameters(const ShearBuilding& building) {
  const Check check{"ShearBuilding", building.name};
  check.that(building.storeys >= 1, "storeys", building.storeys, "", ">= 1");
  building.floor_mass.check(check, "floor_mass", building.storeys);
  building.storey_stiffness.check(check, "storey_stiffness", building.storeys);
  building.storey_height.check(check, "storey_height", building.storeys);
  check.positive("half_width", building.half_width);
  if (building.isolation) {
    check.positive("base_mass", building.base_mass, "An isolated building needs the mass of its base floor.");
    check.that(!building.isolation->has_lower(), "isolation.lower is given.",
               "Leave it out: the bearings stand on the ground.");
    check.that(!building.isolation->has_upper(), "isolation.upper is given.",
               "Leave it out: the bearings carry the base.");
  } else {
    check.that(building.base_mass == Mass{}, "base_mass", building.base_mass.si(), "kg",
               "left out without isolation: the ground is the base", "Give .isolation, or leave out .base_mass.");
  }
}

// Two buildings without names are a likely mistake. A message about a repeated node alone would not help: the script
// did not add the node itself.
void require_new_name(const Model& model, const ShearBuilding& building) {
  const std::string floor = building.name.empty() ? "floor 1" : building.name + " floor 1";
  if (!model.has_node(floor)) return;
  Check{"ShearBuilding", building.name}.that(false, "the model has a node \"" + floor + "\" already.",
                                             "Give every building its own .name.");
}

Building add_nodes(Model& model, const ShearBuilding& building, const std::string& prefix) {
  Length height{};
  const auto node = [&](const std::string& part, Mass mass) {
    return add(
        model,
        Node{
            .name = prefix + part, .mass = mass, .x = building.x, .height = height, .half_width = building.half_width});
  };
  Building added{.name = building.name, .base = building.isolation ? node("base", building.base_mass) : ground};
  for (int floor = 1; floor <= building.storeys; ++floor) {
    height += building.storey_height.of(floor);
    added.floors.push_back(node("floor " + std::to_string(floor), building.floor_mass.of(floor)));
  }
  return added;
}

void add_storeys(Model& model, const ShearBuilding& building, const std::string& prefix, const Building& nodes) {
  const std::vector<Mass> masses = building.floor_mass.list(building.storeys);
  const std::vector<Stiffness> stiffnesses = building.storey_stiffness.list(building.storeys);
  const RayleighFactors rayleigh = rayleigh_factors_of_chain(building.damping.ratio, masses, stiffnesses);
  NodeId below = nodes.base;
  for (std::size_t i = 0; i < nodes.floors.size(); ++i) {
    const NodeId above = nodes.floors[i];
    const std::string number = std::to_string(i + 1);
    add(model,
        ShearSpring{.name = prefix + "storey " + number, .lower = below, .upper = above, .stiffness = stiffnesses[i]});
    if (rayleigh.stiffness_factor > 0.0)
      add(model, ViscousDamper{.name = prefix + "storey " + number + " damping",
                               .lower = below,
                               .upper = above,
                               .damping = rayleigh.stiffness_factor * units::s * stiffnesses[i]});
    if (rayleigh.mass_factor > 0.0)
      add(model, ViscousDamper{.name = prefix + "floor " + number + " damping",
                               .lower = nodes.base,
                               .upper = above,
                               .damping = rayleigh.mass_factor / units::s * masses[i]});
    below = above;
  }
}

}  // namespace

Building add(Model& model, const ShearBuilding& building) {
  check_parameters(building);
  require_new_name(model, building);
  const std::string prefix = building.name.empty() ? "" : building.name + " ";
  Building added = add_nodes(model, building, prefix);
  add_storeys(model, building, prefix, added);
  if (building.isolation) building.isolation->add_to(model, prefix, added.base);
  add(model, added);
  return added;
}

}  // namespace moat
