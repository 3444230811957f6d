// Tour 6: the tower of tour 5, made by hand from diaphragms and elements. Read 05_plan.cpp before.
//
// PlanBuilding and PlanMoat hide nothing: this script makes the same model, and a test asserts the same peaks.
//
//        [ floor i ]     A Diaphragm per floor, with its mass and outline. Between floors a PlanSpring along x and
//          |     |       one along y for every column, and dashpots of Rayleigh damping beside them. A PlanBearing
//        [  base   ]     under every column. A CornerGap for every corner and wall that can meet.
//
//     ./moat run examples/06_plan_by_hand.cpp
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Isolated tower in a moat, in plan, by hand"};
  const Length clearance = script.length("clearance", 25 * cm, "free distance to the walls");
  const double friction = script.number("friction", 0.4, "friction coefficient between base and walls, 0 to 1");
  const PlanMotion motion =
      script.plan_motion({near_fault_pulse({.phase = pi / 4}), near_fault_pulse({.phase = -pi / 4}).scaled_by(0.6)})
          .scaled_to_larger_pga(script.acceleration("pga", 0.4 * g, "larger peak of the two components"));

  const int storeys = 3;
  const Mass floor_mass = 700 * tonne;
  const PlanOutline outline = rectangle(20 * m, 12 * m);
  std::vector<PlanPosition> points;
  for (const Length y : {-6 * m, 6 * m})
    for (const Length x : {-10 * m, 0 * m, 10 * m}) points.push_back({x, y});

  Model model;
  const DiaphragmId base = add(model, Diaphragm{.name = "base", .mass = 800 * tonne, .outline = outline});
  std::vector<DiaphragmId> floors;
  for (int i = 1; i <= storeys; ++i)
    floors.push_back(add(model, Diaphragm{.name = "floor " + std::to_string(i),
                                          .mass = floor_mass,
                                          .centre_of_mass = {1 * m, 0.6 * m},
                                          .outline = outline,
                                          .height = i * 3.5 * m}));

  const PlanVector directions[] = {{1.0, 0.0}, {0.0, 1.0}};
  const auto component = [](PlanVector direction) { return direction.x > 0.0 ? " x" : " y"; };
  const auto below = [&](std::size_t floor) { return floor == 0 ? base : floors[floor - 1]; };
  const Stiffness column = 100 * MN / m;
  for (std::size_t i = 0; i < floors.size(); ++i)
    for (std::size_t k = 0; k < points.size(); ++k)
      for (const PlanVector direction : directions)
        add(model, PlanSpring<Linear>{.name = "storey " + std::to_string(i + 1) + " column " + std::to_string(k + 1) +
                                              component(direction),
                                      .lower = PlanPoint{below(i), points[k]},
                                      .upper = PlanPoint{floors[i], points[k]},
                                      .direction = direction,
                                      .law = {.stiffness = column},
                                      .deformation_quantity = "",
                                      .force_quantity = ""});

  // 5 % in two modes of the superstructure held at its base. The stiffness part is a dashpot beside every column; the
  // mass part acts on the motion of a floor relative to the rigid motion of the base, at the floor's centre of mass.
  const RayleighFactors rayleigh = rayleigh_factors_in_plan(0.05, model, floors);
  const auto dashpot = [&](const std::string& name, PlanPoint lower, PlanPoint upper, PlanVector direction,
                           DampingCoefficient damping) {
    add(model, PlanSpring<Viscous>{.name = name,
                                   .lower = lower,
                                   .upper = upper,
                                   .direction = direction,
                                   .law = {.damping = damping},
                                   .deformation_quantity = "",
                                   .force_quantity = ""});
  };
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    for (std::size_t k = 0; k < points.size(); ++k)
      for (const PlanVector direction : directions)
        dashpot("storey " + number + " column " + std::to_string(k + 1) + component(direction) + " damping",
                {below(i), points[k]}, {floors[i], points[k]}, direction, rayleigh.stiffness_factor * s * column);
    const PlanPosition centre{1 * m, 0.6 * m};
    for (const PlanVector direction : directions)
      dashpot("floor " + number + " damping" + component(direction), {base, centre}, {floors[i], centre}, direction,
              rayleigh.mass_factor / s * floor_mass);
    const RotaryInertia inertia = floor_mass * ((20 * m) * (20 * m) + (12 * m) * (12 * m)) / 12.0;
    add(model, RotationDamper{.name = "floor " + number + " damping rotation",
                              .lower = base,
                              .upper = floors[i],
                              .damping = rayleigh.mass_factor / s * inertia});
  }

  // Bearings under the columns: lead-rubber bearings yield on a circle in plan.
  for (std::size_t k = 0; k < points.size(); ++k)
    add(model, PlanBearing<BiaxialBilinear>{
                   .name = "bearing " + std::to_string(k + 1),
                   .under = base,
                   .at = points[k],
                   .law = {.yield_force = 250 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 2 * MN / m},
                   .place = "bearings"});
  // Periods, drifts and the base shear need the building.
  add(model, Building{.base = base, .floors = {floors.begin(), floors.end()}});

  // Every corner faces two walls: its own, which begins near it, and the one before, which ends there.
  const PlanOutline walls = offset_outwards(outline, clearance);
  const ExactHertzDamp concrete{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65};
  for (std::size_t wall = 0; wall < 4; ++wall)
    for (std::size_t corner = 0; corner < 4; ++corner) {
      if (corner != wall && corner != (wall + 1) % 4) continue;
      const std::string wall_name = "moat wall " + std::to_string(wall + 1),
                        corner_name = "corner " + std::to_string(corner + 1);
      add(model, CornerGap<ExactHertzDamp>{.name = wall_name + " " + corner_name,
                                           .place = "moat",
                                           .corner = PlanPoint{base, outline.corners[corner]},
                                           .edge_of = ground,
                                           .edge_begin = walls.corners[wall],
                                           .edge_end = walls.corners[(wall + 1) % 4],
                                           .law = concrete,
                                           .friction = friction,
                                           .corner_name = "base " + corner_name,
                                           .edge_name = wall_name});
    }

  return script.run(model, motion);
}
