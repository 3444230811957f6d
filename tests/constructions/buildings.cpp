// Buildings on a line, their damping and the weight on their bearings.
#include <gtest/gtest.h>

#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

template <class Change>
std::function<void()> shear_building(Change change) {
  return [change] {
    Model model;
    ShearBuilding house{.name = "house",
                        .storeys = 3,
                        .floor_mass = 500 * tonne,
                        .storey_stiffness = 1 * GN / m,
                        .base_mass = 550 * tonne,
                        .isolation = LeadRubberBearing{.yield_force = 1.9 * MN,
                                                       .yield_displacement = 1 * cm,
                                                       .post_yield_stiffness = 19 * MN / m},
                        .storey_height = 3 * m};
    change(house);
    add(model, house);
  };
}
template <class Change>
std::function<void()> axial_forces(Change change) {
  return shear_building([change](ShearBuilding& house) {
    const FrictionPendulum pendulum{.radius = 2 * m, .friction = 0.06};
    house.isolation = Isolation{Isolator<FrictionPendulum>{.name = "left", .law = pendulum, .at = -5 * m},
                                Isolator<FrictionPendulum>{.name = "right", .law = pendulum, .at = 5 * m}};
    house.axial_forces = AxialForces{};
    change(house);
  });
}
std::function<void()> damping(const RayleighDamping& damping) {
  return shear_building([damping](ShearBuilding& house) { house.damping = damping; });
}

}  // namespace

Constructions buildings() {
  return {
      {"a building without storeys",
       shear_building([](auto& house) { house.storeys = 0; }),
       {"ShearBuilding \"house\"", "storeys", "0", ">= 1", "Give a number in this range"}},
      {"a building of negative mass",
       shear_building([](auto& house) { house.floor_mass = -1 * kg; }),
       {"ShearBuilding \"house\"", "floor_mass", "-1 kg", "> 0 kg and finite", "Check its sign and its unit"}},
      {"a building with a mass too few",
       shear_building([](auto& house) {
         house.floor_mass = {1 * tonne, 2 * tonne};
       }),
       {"ShearBuilding \"house\"", "floor_mass", "2 values", "for 3 storeys", "Give one value for all storeys"}},
      {"a building with one floor without mass",
       shear_building([](auto& house) {
         house.floor_mass = {1 * tonne, 0 * tonne, 1 * tonne};
       }),
       {"ShearBuilding \"house\"", "floor_mass of storey 2", "0 kg", "> 0 kg and finite",
        "Check its sign and its unit"}},
      {"a building without columns",
       shear_building([](auto& house) { house.storey_stiffness = 0 * N / m; }),
       {"ShearBuilding \"house\"", "storey_stiffness", "0 N/m", "> 0 N/m and finite", "Check its sign and its unit"}},
      {"a building with two kinds of columns",
       shear_building(
           [](auto& house) { house.storey = YieldingStorey{.stiffness = 1 * GN / m, .yield_force = 1 * MN}; }),
       {"ShearBuilding \"house\"", "storey_stiffness and storey", "are given", "Give one of them",
        "storey for others"}},
      {"a building of no height",
       shear_building([](auto& house) { house.storey_height = 0 * m; }),
       {"ShearBuilding \"house\"", "storey_height", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"a building without base on bearings",
       shear_building([](auto& house) { house.base_mass = 0 * kg; }),
       {"ShearBuilding \"house\"", "base_mass", "0 kg", "> 0 kg and finite",
        "An isolated building needs the mass of its base floor"}},
      {"a building with a base without bearings",
       shear_building([](auto& house) { house.isolation.reset(); }),
       {"ShearBuilding \"house\"", "base_mass", "550000 kg", "left out without isolation: the ground is the base",
        "Give .isolation, or leave out .base_mass"}},
      {"a building on bearings of a node",
       shear_building(
           [](auto& house) { house.isolation = Isolator<Linear>{.upper = ground, .law = {.stiffness = 1 * MN / m}}; }),
       {"ShearBuilding \"house\"", "isolation.upper", "is given", "Leave it out", "the bearings carry the base"}},
      {"a building with a line for its width",
       shear_building([](auto& house) { house.half_width = 0 * m; }),
       {"ShearBuilding \"house\"", "half_width", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"a building with a name that is taken",
       [] {
         Model model;
         for (int i = 0; i < 2; ++i)
           add(model, ShearBuilding{.storeys = 1, .floor_mass = 1 * tonne, .storey_stiffness = 1 * MN / m});
       },
       {"ShearBuilding", "has a node", "floor 1", "Give every building", "its own .name"}},
      {"a building of floors of another model",
       [] {
         Model model;
         add(model, Node{.name = "floor", .mass = 1 * kg});
         add(model, Building{.name = "house", .floors = {NodeId{5}}});
       },
       {"Building \"house\"", "a floor", "is not a node", "of this model",
        "Use the NodeId that add(model, Node{...}) returned"}},
      {"a floor above the roof",
       [] {
         Model model;
         const Building house =
             add(model, ShearBuilding{.storeys = 1, .floor_mass = 1 * tonne, .storey_stiffness = 1 * MN / m});
         static_cast<void>(house.floor(2));
       },
       {"Building", "floor", "2", ">= 1 and <= 1", "Give a number in this range"}},
      {"damping in per cent",
       damping({.ratio = 5}),
       {"RayleighDamping", "ratio", "5", ">= 0 and < 1", "5 % of critical is 0.05"}},
      {"damping of two ratios in one",
       damping({.ratio = 0.05, .ratios = {0.05, 0.03}, .periods = {1 * s, 0.1 * s}}),
       {"RayleighDamping", "ratios", "together with ratio", "Give .ratios", "or one .ratio"}},
      {"damping at one period twice",
       damping({.ratio = 0.05, .periods = {1 * s, 1 * s}}),
       {"RayleighDamping", "periods", "1 s", "two different ones", "usually those of the first two modes"}},
      {"damping at no period",
       damping({.ratio = 0.05, .periods = {1 * s, 0 * s}}),
       {"RayleighDamping", "periods[1]", "0 s", "> 0 s and finite", "Check its sign and its unit"}},
      {"damping that drives",
       damping({.a0 = -0.3 / s}),
       {"RayleighDamping", "a0", "-0.3 1/s", ">= 0 1/s and finite", "Check its sign and its unit"}},
      {"damping by ratio and by factors",
       damping({.ratio = 0.05, .a1 = 2 * ms}),
       {"RayleighDamping", "a0 or a1", "together with ratios or periods", "Give a0 and a1", "alone"}},
      {"damping with factors that drive",
       damping({.ratios = {0.001, 0.5}, .periods = {1 * s, 0.9 * s}}),
       {"RayleighDamping", "these ratios at these periods", "negative damping", "1.00021 s",
        "Give a larger ratio at the longer period"}},
      {"axial forces below the bearings",
       axial_forces([](auto& house) { house.axial_forces->base_height = -1 * m; }),
       {"ShearBuilding \"house\"", "axial_forces.base_height", "-1 m", ">= 0 m and finite",
        "Check its sign and its unit"}},
      {"axial forces of a slow vertical mode",
       axial_forces([](auto& house) { house.axial_forces->vertical_period = 2 * s; }),
       {"ShearBuilding \"house\"", "axial_forces.vertical_period", "2 s", ">= 0.01 and <= 1",
        "Leave it out: the building then moves vertically with the"}},
      {"axial forces with critical vertical damping",
       axial_forces([](auto& house) {
         house.axial_forces->vertical_period = 0.1 * s;
         house.axial_forces->vertical_damping = 1;
       }),
       {"ShearBuilding \"house\"", "axial_forces.vertical_damping", "1", ">= 0 and < 1",
        "Give a number in this range"}},
      {"axial forces of bearings that push up",
       axial_forces([](auto& house) { house.axial_forces->may_pull = -1 * N; }),
       {"ShearBuilding \"house\"", "axial_forces.may_pull", "-1 N", ">= 0 N and finite",
        "Check its sign and its unit"}},
      {"axial forces without heights",
       axial_forces([](auto& house) { house.storey_height = PerStorey<Length>::unless_given(3.5 * m); }),
       {"ShearBuilding \"house\"", "axial_forces", "storey_height", "is left out", "Give the heights of its storeys"}},
      {"axial forces of one bearing",
       axial_forces([](auto& house) { house.isolation = FrictionPendulum{.radius = 2 * m, .friction = 0.06}; }),
       {"Isolation", "axial_forces", "one position", "Give isolators", "at two positions"}},
      {"axial forces without bearings",
       axial_forces([](auto& house) {
         house.isolation.reset();
         house.base_mass = 0 * kg;
       }),
       {"ShearBuilding \"house\"", "axial_forces", "without isolation", "Give .isolation", "leave .axial_forces out"}},
      {"axial forces with one weight that is given",
       axial_forces([](auto& house) {
         const FrictionPendulum pendulum{.radius = 2 * m, .friction = 0.06};
         house.isolation =
             Isolation{Isolator<FrictionPendulum>{.name = "left", .law = pendulum, .weight = 1 * MN, .at = -5 * m},
                       Isolator<FrictionPendulum>{.name = "right", .law = pendulum, .at = 5 * m}};
       }),
       {"Isolation", "axial_forces", "1 of 2 bearings", "Give the weight", "of every bearing, or of none"}},
      {"a tower of 1 gram floors",
       [] {
         // One floor: T = 2 pi sqrt(m/k).
         Model model;
         add(model, ShearBuilding{.storeys = 1, .floor_mass = 1e-3 * kg, .storey_stiffness = 1e-3 * N / m});
         EXPECT_NEAR(characteristic_periods(model).at(0).value, 2 * pi, 1e-12);
       }},
      {"a base heavier than its building by 1e9",
       [] {
         // The base moves as if alone, on k_2: 2 pi sqrt((M + m)/k_2).
         Model model;
         add(model, ShearBuilding{
                        .storeys = 1,
                        .floor_mass = 1 * kg,
                        .storey_stiffness = 1 * MN / m,
                        .base_mass = 1e9 * kg,
                        .isolation = LeadRubberBearing{
                            .yield_force = 1 * MN, .yield_displacement = 1 * mm, .post_yield_stiffness = 1e6 * N / m}});
         for (const NamedPeriod& period : characteristic_periods(model)) {
           if (period.name == "first mode, post-yield bearings") {
             EXPECT_NEAR(period.value, 2 * pi * std::sqrt(1e3), 1e-6);
           }
         }
       }},
  };
}

}  // namespace moat::constructions
