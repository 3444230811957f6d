// Tour 8: friction pendulums whose friction rises with speed. Read 01_moat_wall.cpp before.
//
//      [ base ] -> u         F = (W/R) u + mu(|v|) W sgn v          mu from 0.03 at rest to 0.06 at speed
//     -----(_)-----
//      \_________/           A bilinear model has one friction. Taken from fast tests, it is right at speed; it then
//                            sticks too early where the motion turns, and stops elsewhere.
//
// The picture loops.svg shows both loops: the corners of the pendulum are round where it turns.
//
//     ./moat run examples/08_friction_pendulum.cpp
//     ./moat run examples/08_friction_pendulum.cpp --slow 0.06 --picture same.svg      friction as in the bilinear
//     model
#include <moat.hpp>

#include <cstdio>

using namespace moat;
using namespace moat::units;

ShearBuilding five_storeys(Isolation isolation) {
  return {.storeys = 5,
          .floor_mass = 500 * tonne,
          .storey_stiffness = 1 * GN / m,
          .damping = RayleighDamping{.ratio = 0.05},
          .base_mass = 550 * tonne,
          .isolation = isolation};
}

// Force over deformation of the bearings.
Series loop(const std::string& name, Isolation isolation, const GroundMotion& motion) {
  Model model;
  add(model, five_storeys(isolation));
  const CaseResult result = run_case(model, motion, {.history_interval = 5 * ms});
  Series series{.name = name, .x = {}, .y = {}};
  for (const double u : result.histories.values("isolator_deformation", "bearings")) series.x.push_back(100 * u);
  for (const double f : result.histories.values("isolator_force", "bearings")) series.y.push_back(f / 1e6);
  std::printf("%-28s stays at %5.1f cm\n", name.c_str(), series.x.back());
  return series;
}

int main(int argc, char** argv) {
  Script script{argc, argv, "Five-storey building on friction pendulums"};
  const double slow = script.number("slow", 0.03, "coefficient of friction at rest");
  const std::string picture = script.text("picture", "loops.svg", "file of the picture");
  const GroundMotion motion = script.motion(near_fault_pulse()).scaled_to_pga(0.4 * g);

  const FrictionPendulum pendulum{.radius = 3 * m,
                                  .friction = VelocityDependent{.slow = slow, .fast = 0.06, .rate = 50 * s / m}};
  const FrictionPendulum one_friction{.radius = 3 * m, .friction = 0.06};

  write_svg(Chart{.title = "Pendulum and bilinear model",
                  .x_label = "deformation of the bearings [cm]",
                  .y_label = "force [MN]",
                  .series = {loop("friction rises with speed", pendulum, motion),
                             loop("one friction (bilinear)", one_friction, motion)}},
            picture);

  Model model;
  add(model, five_storeys(pendulum));
  return script.run(model, motion);  // the report lists friction_coefficient and isolator_slip
}
