// Tour 7: how large must the moat of a building in plan be? All angles of incidence, and accidental eccentricities.
// Read 05_plan.cpp before.
//
//        y ^  second component        The angle at which a motion comes is not known: the study turns the pair of
//          | /                        components step by step and keeps the largest of every result. The centres of
//          |/__ first, at the angle   mass are not where the drawing has them: four cases move them by 5 % of the
//          +-----------> x            plan. All cases run on all cores.
//
//     ./moat run examples/07_incidence.cpp
//     ./moat run examples/07_incidence.cpp --step 5
#include <moat.hpp>

#include <cstdio>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Angles of incidence and accidental eccentricities"};
  const double step = script.number("step", 30.0, "step of the angle in degrees, a whole part of 360");
  const Length clearance = script.length("clearance", 23 * cm, "free distance to the walls");

  const PlanBuilding building{.outline = rectangle(20 * m, 12 * m),
                              .storeys = 2,
                              .floor_mass = 700 * tonne,
                              .columns = grid(3, 2, {.stiffness = 100 * MN / m}),
                              .damping = RayleighDamping{.ratio = 0.05},
                              .base_mass = 800 * tonne,
                              .bearings = grid(3, 2,
                                               LeadRubberBearing{.yield_force = 200 * kN,
                                                                 .yield_displacement = 1 * cm,
                                                                 .post_yield_stiffness = 1.5 * MN / m})};
  const auto model_of = [&](const PlanBuilding& each) {
    Model model;
    const auto tower = add(model, each);
    add(model, PlanMoat{.around = tower.base,
                        .clearance = clearance,
                        .law = ExactHertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65},
                        .friction = 0.4});
    return model;
  };
  const PlanMotion motion =
      PlanMotion{near_fault_pulse({.phase = pi / 4}), near_fault_pulse({.phase = -pi / 4}).scaled_by(0.6)}
          .scaled_to_larger_pga(0.35 * g);

  script.check_options();

  const EnvelopeStudy angles = incidence_study(model_of(building), motion, step * deg);
  const EnvelopeStudy shifts = eccentricity_study(
      [&](PlanVector share) { return model_of(with_eccentricity(building, share.x, share.y)); }, motion);
  const auto print = [](const char* title, const EnvelopeStudy& study) {
    std::printf("%s\n", title);
    for (const auto& [quantity, where] :
         {std::pair{"corner_displacement", "base"}, std::pair{"rotation", "base"}, std::pair{"corner_drift", "floor 1"},
          std::pair{"absolute_acceleration", "floor 2"}, std::pair{"impact_force", "moat"}}) {
      const EnvelopeEntry& entry = study.largest(quantity, where);
      std::printf("  %-22s %-8s %12.5g %-6s %s\n", quantity, where, entry.value, entry.unit.c_str(), entry.at.c_str());
    }
  };
  // Some angles reach the walls, others do not.
  const std::vector<double> corners = angles.cases.values("corner_displacement", "base"),
                            forces = angles.cases.values("impact_force", "moat");
  std::printf("Angle [deg]   corner displacement [m]   impact force [MN]\n");
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::printf("%11g   %23.4f   ", angles.cases.axes().front().values[i], corners[i]);
    if (forces[i] > 0.0)
      std::printf("%17.2f\n", forces[i] / 1e6);
    else
      std::printf("%17s\n", "none");
  }
  print("Largest over all angles of incidence", angles);
  print("Largest over accidental eccentricities", shifts);
  return 0;
}
