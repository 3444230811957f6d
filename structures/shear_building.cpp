#include "structures/shear_building.hpp"

#include <algorithm>
#include <vector>

#include "base/check.hpp"
#include "base/error.hpp"
#include "elements/block/link_checks.hpp"
#include "elements/line/shear_spring.hpp"
#include "elements/line/viscous_damper.hpp"
#include "materials/storeys/p_delta.hpp"
#include "structures/static_weights.hpp"

namespace moat {
namespace {

void check_parameters(const ShearBuilding& building) {
  const Check check{"ShearBuilding", building.name};
  check.that(building.storeys >= 1, "storeys", building.storeys, "", ">= 1");
  building.floor_mass.check(check, "floor_mass", building.storeys);
  if (building.storey) {
    check.that(building.storey_stiffness.of(1) == Stiffness{}, "storey_stiffness and storey are given.",
               "Give one of them: storey_stiffness for linear storeys, storey for others.");
    building.storey->check_count(check, "storey", building.storeys);
  } else {
    building.storey_stiffness.check(check, "storey_stiffness", building.storeys);
  }
  building.storey_height.check(check, "storey_height", building.storeys);
  check.positive("half_width", building.half_width);
  if (building.axial_forces) {
    check_axial_forces(check, *building.axial_forces, building.storey_height.is_given());
    check.that(building.isolation.has_value(), "axial_forces are asked without isolation.",
               "Give .isolation, or leave .axial_forces out.");
  }
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

std::vector<Stiffness> initial_stiffnesses(const ShearBuilding& building) {
  if (!building.storey) return building.storey_stiffness.list(building.storeys);
  std::vector<Stiffness> stiffnesses;
  for (const StoreyLaw& law : building.storey->list(building.storeys))
    stiffnesses.push_back(law.initial_stiffness() * units::N / units::m);
  return stiffnesses;
}

Force weight_above(const ShearBuilding& building, int storey) {
  Mass mass = {};
  for (int floor = building.storeys; floor >= storey; --floor) mass += building.floor_mass.of(floor);
  return mass * units::g;
}

void add_p_delta(Model& model, const ShearBuilding& building, const std::string& name, int storey, NodeId lower,
                 NodeId upper, Stiffness stiffness) {
  const PDelta law{.weight = weight_above(building, storey), .height = building.storey_height.of(storey)};
  const Check check{"ShearBuilding", building.name};
  check.that(-law.stiffness() < stiffness.si(),
             "p_delta: weight above / storey_height of storey " + std::to_string(storey), -law.stiffness(), "N/m",
             "below its stiffness, " + to_text(stiffness.si()) + " N/m", "The storey would fall over.");
  add_link(model, "PDelta", {.name = name, .first = lower, .second = upper, .drawn_as = DrawnAs::nothing}, law);
}

void add_storeys(Model& model, const ShearBuilding& building, const std::string& prefix, const Building& nodes) {
  const std::vector<Mass> masses = building.floor_mass.list(building.storeys);
  const std::vector<Stiffness> stiffnesses = initial_stiffnesses(building);
  const std::optional<RayleighFactors> given = given_factors(building.damping);
  const RayleighFactors rayleigh =
      given ? *given : rayleigh_factors_of_chain(building.damping.ratio, masses, stiffnesses);
  NodeId below = nodes.base;
  for (std::size_t i = 0; i < nodes.floors.size(); ++i) {
    const NodeId above = nodes.floors[i];
    const std::string number = std::to_string(i + 1);
    const std::string name = prefix + "storey " + number;
    if (building.storey)
      building.storey->of(static_cast<int>(i) + 1).add_to(model, name, below, above);
    else
      add(model, ShearSpring{.name = name, .lower = below, .upper = above, .stiffness = stiffnesses[i]});
    if (building.p_delta)
      add_p_delta(model, building, name + " P-delta", static_cast<int>(i) + 1, below, above, stiffnesses[i]);
    if (rayleigh.stiffness_factor > 0.0)
      add(model, ViscousDamper{.name = name + " damping",
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

// The element that was added with this name.
ElementId element_named(const Model& model, const std::string& name) {
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const auto& infos = model.blocks()[b]->infos();
    const auto found = std::ranges::find(infos, name, &ElementInfo::name);
    if (found != infos.end()) return {b, static_cast<std::size_t>(found - infos.begin())};
  }
  throw InputError{"ShearBuilding: there is no element \"" + name + "\"."};
}

// The moments of the elastic forces on all floors above a storey about its lower floor: the sum of the shears of this
// storey and of those above it, each times its height.
void add_overturning_moments(const Model& model, const ShearBuilding& building, const std::string& prefix,
                             Building& added) {
  StoreyResult moment{.quantity = "overturning_moment", .place = "", .unit = "N m"};
  for (int storey = building.storeys; storey >= 1; --storey) {
    moment.place = prefix + "storey " + std::to_string(storey);
    const double height = building.storey_height.of(storey).si();
    if (building.storey) {
      moment.forces.push_back({element_named(model, moment.place), height});
    } else {
      const double weight = height * building.storey_stiffness.of(storey).si();
      const NodeId below = storey == 1 ? added.base : added.floor(storey - 1);
      moment.displacements.push_back({added.floor(storey), weight});
      if (below != ground) moment.displacements.push_back({below, -weight});
    }
    added.storey_results.push_back(moment);
  }
  std::ranges::reverse(added.storey_results);
}

}  // namespace

Building add(Model& model, const ShearBuilding& building) {
  check_parameters(building);
  const std::string prefix = building.name.empty() ? "" : building.name + " ";
  // Two buildings without names are a likely mistake. A message about a repeated node alone would not help: the script
  // did not add the node itself.
  Check{"ShearBuilding", building.name}.that(!model.has_node(prefix + "floor 1"),
                                             "the model has a node \"" + prefix + "floor 1\" already.",
                                             "Give every building its own .name.");
  Building added = add_nodes(model, building, prefix);
  add_storeys(model, building, prefix, added);
  add_overturning_moments(model, building, prefix, added);
  if (building.isolation)
    building.isolation->add_to(model, prefix, added.base, weight_above(building, 1) + building.base_mass * units::g,
                               building.axial_forces);
  added.axial_forces = building.axial_forces;
  add(model, added);
  return added;
}

}  // namespace moat
