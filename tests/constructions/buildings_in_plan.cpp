// Buildings in plan.
#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

template <class Change>
std::function<void()> plan_building(Change change) {
  return [change] {
    Model model;
    PlanBuilding tower{.name = "tower",
                       .outline = rectangle(20 * m, 12 * m),
                       .storeys = 2,
                       .floor_mass = 400 * tonne,
                       .columns = grid(3, 2, StoreyColumn{.stiffness = 50 * MN / m}),
                       .base_mass = 450 * tonne,
                       .bearings = grid(3, 2, BiaxialLinear{.stiffness = 2 * MN / m})};
    change(tower);
    add(model, tower);
  };
}

}  // namespace

Constructions buildings_in_plan() {
  return {
      {"a plan without edge",
       plan_building([](auto& tower) { tower.outline = PlanOutline{}; }),
       {"PlanBuilding \"tower\"", "outline", "0 corners", "Give", "at least three"}},
      {"a plan with columns of both kinds",
       plan_building([](auto& tower) {
         tower.columns = grid(3, 2, StoreyColumn{.stiffness = 1 * MN / m, .stiffness_x = 1 * MN / m});
       }),
       {"PlanBuilding \"tower\"", "storey 1 column 1: stiffness", "is given", "stiffness_x or stiffness_y too",
        "Give one for both directions"}},
      {"a plan on one line of columns",
       plan_building([](auto& tower) {
         tower.columns = std::vector<ColumnLine>{{.at = {1 * m, 0 * m}, .column = {.stiffness = 1 * MN / m}}};
       }),
       {"PlanBuilding \"tower\"", "storey 1", "every motion in plan", "eigenvalue of its stiffness is 0 N/m",
        "Give column lines at two places"}},
      {"a storey that twists freely",
       plan_building(
           [](auto& tower) { tower.columns = StoreyStiffness{.x = 1 * MN / m, .y = 1 * MN / m, .rotation = 0 * J}; }),
       {"PlanBuilding \"tower\"", "tower storey 1 columns.rotation", "0 N m/rad", "> 0 N m/rad and finite",
        "Check its sign and its unit"}},
      {"a plan on a grid of nothing",
       plan_building([](auto& tower) {
         tower.bearings = Grid<BiaxialLinear>{0, 2, {.stiffness = 2 * MN / m}};
       }),
       {"PlanBuilding \"tower\"", "bearings", "0 by 2 points", "at least 1", "in each direction"}},
      {"a plan of negative inertia",
       plan_building([](auto& tower) { tower.rotary_inertia = -1 * kg * m_2; }),
       {"PlanBuilding \"tower\"", "rotary_inertia of floor 1", "-1 kg m^2", ">= 0 kg m^2 and finite",
        "Check its sign and its unit"}},
      {"a plan with the mass beside it",
       plan_building([](auto& tower) {
         tower.mass_offset = PlanPosition{30 * m, 0 * m};
       }),
       {"Diaphragm \"tower floor 1\"", "centre_of_mass.x", "30 m", "from -10 m to 10 m",
        "coordinates of the whole model"}},
      {"a plan with mass at no place",
       plan_building([](auto& tower) {
         tower.mass_offset = PlanPosition{not_a_number * m, 0 * m};
       }),
       {"Diaphragm \"tower floor 1\"", "centre_of_mass.x", "nan m", "a finite number", "division by zero"}},
      {"a plan with bearings without base",
       plan_building([](auto& tower) { tower.base_mass = 0 * kg; }),
       {"PlanBuilding \"tower\"", "base_mass", "0 kg", "> 0 kg and finite",
        "A building on bearings needs the mass of its base floor"}},
      {"a plan with axial forces and no heights",
       plan_building([](auto& tower) { tower.axial_forces = AxialForces{}; }),
       {"PlanBuilding \"tower\"", "axial_forces", "storey_height", "is left out", "Give the heights of its storeys"}},
      {"an eccentricity of the whole plan",
       [] {
         static_cast<void>(with_eccentricity(PlanBuilding{.outline = rectangle(20 * m, 12 * m),
                                                          .storeys = 1,
                                                          .floor_mass = 1 * tonne,
                                                          .columns = grid(2, 2, StoreyColumn{1 * MN / m})},
                                             0.6, 0.0));
       },
       {"with_eccentricity", "share_of_x", "0.6", "from -0.5 to 0.5", "5 % is 0.05"}},
      {"a torsion by formula of a point",
       [] { static_cast<void>(torsional_amplification(10 * m, 1 * m, 0 * m, 12 * m, 1.0)); },
       {"torsional_amplification", "b", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"a torsion slower than the translation",
       [] { static_cast<void>(torsional_amplification(10 * m, 1 * m, 20 * m, 12 * m, 0.5)); },
       {"torsional_amplification", "period_ratio", "0.5", ">= 1", "Give a number in this range"}},
      {"no modes in plan",
       [] {
         Model model;
         add(model, Diaphragm{.name = "floor", .mass = 1 * kg, .size = {1 * m, 1 * m}, .free = true});
         static_cast<void>(plan_modes(model, StiffnessStage::initial, 0));
       },
       {"plan_modes", "count", "0", ">= 1", "Give a number in this range"}},
  };
}

}  // namespace moat::constructions
