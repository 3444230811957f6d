// Laws of isolators, storeys, dampers and soil on a line.
#include <gtest/gtest.h>

#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

// The displacement, m, at `time` of a free mass on a spring that starts at 1 mm.
void expect_free_vibration(Mass mass, Stiffness stiffness, Time time, double tolerance) {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = mass, .initial_displacement = 1 * mm});
  add(model, Spring<Linear>{.name = "spring", .lower = ground, .upper = body, .law = {.stiffness = stiffness}});
  Transient analysis{model, still_ground(1 * s), {.integrator = ExactBetweenEvents{}, .end = time}};
  analysis.run();
  const double w = std::sqrt(stiffness.si() / mass.si());
  EXPECT_NEAR(analysis.state().displacement(body), 1e-3 * std::cos(w * time.si()), tolerance * 1e-3);
}

Constructions simple_laws() {
  const auto bilinear = [](Force force, Length displacement, Stiffness after) {
    return [=] {
      add_link(Bilinear{.yield_force = force, .yield_displacement = displacement, .post_yield_stiffness = after});
    };
  };
  return {
      {"linear without stiffness",
       [] { add_link(Linear{.stiffness = 0 * N / m}); },
       {"Isolator \"link\"", "stiffness", "0 N/m", "> 0 N/m and finite", "Check its sign and its unit"}},
      {"linear that feeds energy",
       [] { add_link(Linear{.stiffness = 1 * N / m, .damping = -1 * N * s / m}); },
       {"Isolator \"link\"", "damping", "-1 N s/m", ">= 0 N s/m and finite", "Check its sign and its unit"}},
      {"viscous of no number",
       [] { add_link(Viscous{.damping = not_a_number * N * s / m}); },
       {"Isolator \"link\"", "damping", "nan N s/m", "> 0 N s/m and finite", "division by zero"}},
      {"bilinear without yield displacement",
       bilinear(1 * N, 0 * m, 0 * N / m),
       {"Isolator \"link\"", "yield_displacement", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"bilinear that stiffens",
       bilinear(1 * N, 1 * cm, 200 * N / m),
       {"Isolator \"link\"", "post_yield_stiffness", "200 N/m",
        "below the initial stiffness yield_force / yield_displacement = 100 N/m",
        "Check the exponents of the three parameters"}},
      {"bilinear of infinite strength",
       bilinear(infinite * N, 1 * cm, 0 * N / m),
       {"Isolator \"link\"", "yield_force", "inf N", "> 0 N and finite", "division by zero"}},
      {"a speck of dust on a cobweb", [] { expect_free_vibration(1e-12 * kg, 1e-10 * N / m, 0.9 * s, 1e-6); }},
      {"a mountain on a period of 100 s",
       [] { expect_free_vibration(1e12 * kg, 1e12 * 4e-4 * pi * pi * N / m, 25 * s, 1e-6); }},
  };
}

Constructions isolator_laws() {
  return {
      {"bouc-wen that gains energy",
       link<BoucWen>([](auto& law) { law.beta = 0.4; }),
       {"Isolator \"link\"", "beta", "0.4", "from 0.5 to 10", "Below 1/2 small cycles would gain energy"}},
      {"bouc-wen with a corner too sharp",
       link<BoucWen>([](auto& law) { law.exponent = 51; }),
       {"Isolator \"link\"", "exponent", "51", "from 1 to 50", "1 to 2 is usual; 50 is nearly bilinear"}},
      {"bouc-wen that hardens without bend",
       link<BoucWen>([](auto& law) { law.hardening_exponent = 1; }),
       {"Isolator \"link\"", "hardening_exponent", "1", "> 1 and <= 10", "Give a number in this range"}},
      {"double pendulum with surfaces exchanged",
       link<DoublePendulum>([](auto& law) { law.first_friction = 0.2; }),
       {"Isolator \"link\"", "first_friction", "0.2", "> 0 and <= 0.07",
        "The surface with less friction is the first"}},
      {"double pendulum that grips",
       link<DoublePendulum>([](auto& law) { law.second_friction = 0.5; }),
       {"Isolator \"link\"", "second_friction", "0.5", "> 0 and <= 0.3", "Give a number in this range"}},
      {"slider that pushes away",
       link<FlatSlider>([](auto& law) { law.restoring_stiffness = -1 * N / m; }),
       {"Isolator \"link\"", "restoring_stiffness", "-1 N/m", ">= 0 N/m and finite", "Check its sign and its unit"}},
      {"slider without weight",
       [] {
         Model model;
         const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne});
         add(model, Isolator<FlatSlider>{.name = "link", .upper = body, .law = FlatSlider::typical()});
       },
       {"Isolator \"link\"", "weight", "0 N", "> 0 N and finite",
        "Give the weight that it carries; a ShearBuilding knows its"}},
      {"pendulum that is convex",
       link<FrictionPendulum>([](auto& law) { law.radius = -1 * m; }),
       {"Isolator \"link\"", "radius", "-1 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"pendulum that is pulled",
       link<FrictionPendulum>([](auto& law) { law.weight = -1 * N; }),
       {"Isolator \"link\"", "weight", "-1 N", ">= 0 N and finite", "Check its sign and its unit"}},
      {"rubber that turns over",
       link<GrantRubber>([](auto& law) { law.a2 = -1e8 * N / (m * m * m); }),
       {"Isolator \"link\"", "a2", "-1e+08 N/m^3", "so that a1 + 3 a2 d^2 + 5 a3 d^4 >= 0 at every d",
        "The elastic force must grow with d"}},
      {"rubber that wears without end",
       link<GrantRubber>([](auto& law) { law.c3 = 0; }),
       {"Isolator \"link\"", "c3", "0", "> 0 and <= 1", "Give a number in this range"}},
      {"lead without steel",
       link<HeatedLeadRubber>([](auto& law) { law.shim_thickness = law.lead_height.value(); }),
       {"Isolator \"link\"", "shim_thickness", "0.2238 m", "> 0 and below lead_height = 0.2238 m",
        "Give the sum over all shims"}},
      {"lead that hardens by heat",
       link<HeatedLeadRubber>([](auto& law) { law.weakening = -1; }),
       {"Isolator \"link\"", "weakening", "-1 1/K", ">= 0 1/K and finite", "Check its sign and its unit"}},
      {"lead of no density",
       link<HeatedLeadRubber>([](auto& law) { law.lead_density = 0 * kg / m_3; }),
       {"Isolator \"link\"", "lead_density", "0 kg/m^3", "> 0 kg/m^3 and finite", "Check its sign and its unit"}},
      {"lead that stores no heat",
       link<HeatedLeadRubber>([](auto& law) { law.lead_specific_heat = 0; }),
       {"Isolator \"link\"", "lead_specific_heat", "0 J/(kg K)", "> 0 J/(kg K) and finite",
        "Check its sign and its unit"}},
      {"high-damping rubber without area",
       link<KikuchiAikenRubber>([](auto& law) { law.area = 0 * m_2; }),
       {"Isolator \"link\"", "area", "0 m^2", "> 0 m^2 and finite", "Check its sign and its unit"}},
      {"a stop at the start",
       link<StiffeningSpring>([](auto& law) { law.start = 0 * m; }),
       {"Isolator \"link\"", "start", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"triple pendulum with friction exchanged",
       link<TriplePendulum>([](auto& law) { law.inner_friction = 0.05; }),
       {"Isolator \"link\"", "inner_friction", "0.05", "> 0 and below lower_friction = 0.04",
        "Three sliders in series need friction that rises from"}},
      {"triple pendulum with a short lower surface",
       link<TriplePendulum>([](auto& law) { law.lower_capacity = 0.1 * m; }),
       {"Isolator \"link\"", "lower_capacity", "0.1 m", ">= (upper_friction - lower_friction) lower_radius = 0.14986 m",
        "Else the lower surface reaches its stop before the upper"}},
      {"triple pendulum with a small bowl",
       link<TriplePendulum>([](auto& law) { law.lower_radius = 0.1 * m; }),
       {"Isolator \"link\"", "lower_radius", "0.1 m", "above inner_radius = 0.3937 m", "Check its sign and its unit"}},
      {"heated pendulum of hot steel",
       link<HeatedFrictionPendulum>([](auto& law) {
         PressureTemperatureVelocity friction = law.friction;
         friction.initial_temperature = 200;
         law.friction = friction;
       }),
       {"Isolator \"link\"", "friction.initial_temperature", "200 degrees Celsius",
        "from -50 degrees Celsius to 100 degrees Celsius", "Check its sign and its unit"}},
      {"heated pendulum without slider",
       link<HeatedFrictionPendulum>([](auto& law) {
         PressureTemperatureVelocity friction = law.friction;
         friction.slider_radius = 0 * m;
         law.friction = friction;
       }),
       {"Isolator \"link\"", "friction.slider_radius", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
  };
}

Constructions friction_models() {
  const auto pendulum = [](const Friction& friction) {
    return [friction] { add_link(FrictionPendulum{.radius = 2 * m, .friction = friction}); };
  };
  return {
      {"friction of glue",
       pendulum(Coulomb{.coefficient = 0.4}),
       {"Isolator \"link\"", "friction.coefficient", "0.4", "> 0 and <= 0.3", "Give a number in this range"}},
      {"friction that falls with speed",
       pendulum(VelocityDependent{.slow = 0.08, .fast = 0.06, .rate = 50 * s / m}),
       {"Isolator \"link\"", "friction.slow", "0.08", "> 0 and <= 0.06",
        "Friction at rest is at most that at high speed"}},
      {"friction that knows no speed",
       pendulum(VelocityDependent{.slow = 0.04, .fast = 0.06, .rate = 400 * s / m}),
       {"Isolator \"link\"", "friction.rate", "400 s/m", "> 0 s/m and <= 300 s/m", "20 to 100 s/m is usual"}},
      {"friction gone under pressure",
       pendulum(VelocityPressureDependent{.slow = 0.01,
                                          .at_zero_pressure = 0.1,
                                          .reduction = 0.1,
                                          .pressure_factor = 1e-8 * m_2 / N,
                                          .area = 0.1 * m_2,
                                          .rate = 50 * s / m}),
       {"Isolator \"link\"", "friction.reduction", "0.1", ">= 0 and below at_zero_pressure",
        "Give a number in this range"}},
      {"friction that grows with force",
       pendulum(VelocityForceDependent{.slow_at_reference = 0.04,
                                       .fast_at_reference = 0.08,
                                       .reference_force = 1 * MN,
                                       .fast_exponent = 1.2,
                                       .rate = 50 * s / m}),
       {"Isolator \"link\"", "friction.fast_exponent", "1.2", "> 0 and <= 1", "Give a number in this range"}},
      {"friction without pressure",
       pendulum(KumarFriction{.reference_coefficient = 0.06, .reference_pressure = 0 * Pa, .area = 0.1 * m_2}),
       {"Isolator \"link\"", "friction.reference_pressure", "0 Pa", "> 0 Pa and finite",
        "Check its sign and its unit"}},
      {"friction without force",
       pendulum(LomientoFriction{.at_zero_force = 0.1, .reference_force = 0 * N}),
       {"Isolator \"link\"", "friction.reference_force", "0 N", "> 0 N and finite", "Check its sign and its unit"}},
      {"friction of hot grease",
       pendulum(LubricatedPtfe{.area = 0.1 * m_2, .temperature_factor = 1.2}),
       {"Isolator \"link\"", "friction.temperature_factor", "1.2", "> 0 and <= 1", "Give a number in this range"}},
  };
}

Constructions other_laws() {
  return {
      {"damper without brace",
       link<MaxwellDamper>([](auto& law) { law.brace_stiffness = 0 * N / m; }),
       {"Isolator \"link\"", "brace_stiffness", "0 N/m", "> 0 N/m and finite",
        "Without a brace take NonlinearViscous"}},
      {"damper that is faster than fluid",
       link<MaxwellDamper>([](auto& law) { law.exponent = 1.2; }),
       {"Isolator \"link\"", "exponent", "1.2", "from 0.1 to 1", "Fluid dampers have 0.15 to 1"}},
      {"damper that jumps at rest",
       link<NonlinearViscous>([](auto& law) { law.rounding_speed = 0 * m / s; }),
       {"Isolator \"link\"", "rounding_speed", "0 m/s", "> 0 m/s and finite", "Use 1 % of the peak speed or less"}},
      {"degrading storey that pinches beyond the peak",
       link<BaberNoori>([](auto& law) { law.pinching_place = 1; }),
       {"Isolator \"link\"", "pinching_place", "1", ">= 0 and < 1", "Give a number in this range"}},
      {"degrading storey that mends itself",
       link<BaberNoori>([](auto& law) { law.loss_of_stiffness = -1.0 / J; }),
       {"Isolator \"link\"", "loss_of_stiffness", "-1 1/J", ">= 0 1/J and finite", "Check its sign and its unit"}},
      {"degrading storey without coupling",
       link<BaberNoori>([](auto& law) { law.coupling = 0; }),
       {"Isolator \"link\"", "coupling", "0", "> 0 and finite", "Give a number in this range"}},
      {"storey that ends before it yields",
       link<ImkBilinear>([](auto& law) { law.ultimate_drift = 5 * mm; }),
       {"Isolator \"link\"", "ultimate_drift", "0.005 m", "above the yield drift yield_force / stiffness = 0.01 m",
        "Check its sign and its unit"}},
      {"storey that keeps more than it had",
       link<ImkBilinear>([](auto& law) { law.residual_ratio = 1; }),
       {"Isolator \"link\"", "residual_ratio", "1", ">= 0 and < 1", "Give a number in this range"}},
      {"storey with a steep cap",
       link<ImkBilinear>([](auto& law) {
         law.cap_ratio = 9;
         law.hardening_drift = 0.1 * mm;
       }),
       {"Isolator \"link\"", "cap_ratio", "9", "so that the storey hardens with less than its stiffness",
        "Give a longer hardening_drift"}},
      {"leaning columns of no height",
       link<PDelta>([](auto& law) { law.height = 0 * m; }),
       {"Isolator \"link\"", "height", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"storey that hardens as it was",
       link<YieldingStorey>([](auto& law) { law.hardening_ratio = 1; }),
       {"Isolator \"link\"", "hardening_ratio", "1", ">= 0 and < 1", "0.02 to 0.1 is usual"}},
      {"soil that is softer on the way back",
       link<HyperbolicBackfill>([](auto& law) { law.unloading_stiffness = 1 * N / m; }),
       {"Isolator \"link\"", "unloading_stiffness", "1 N/m", ">= initial_stiffness = 2.03e+08 N/m",
        "A softer line would give back more energy than went in"}},
      {"soil that never fails",
       link<HyperbolicBackfill>([](auto& law) { law.failure_ratio = 1.1; }),
       {"Isolator \"link\"", "failure_ratio", "1.1", "> 0 and <= 1", "0.7 to 0.95 is usual"}},
      {"soil behind a wall of no height",
       [] { static_cast<void>(HyperbolicBackfill::behind(BackfilledWall{.height = 0 * m, .width = 10 * m})); },
       {"HyperbolicBackfill::behind", "height", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
  };
}

}  // namespace

Constructions laws() {
  Constructions all = simple_laws();
  for (const auto& more : {isolator_laws(), friction_models(), other_laws()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

Constructions laws_in_plan() {
  const auto bearing = [](const auto& law) {
    return [law] {
      Model model;
      const DiaphragmId base = add(model, Diaphragm{.name = "base", .mass = 100 * tonne, .size = {10 * m, 10 * m}});
      add(model, PlanBearing<std::remove_cvref_t<decltype(law)>>{.name = "bearing", .under = base, .law = law});
    };
  };
  BiaxialGrantRubber torn{GrantRubber::typical()};
  torn.rubber.b3 = 0.0 / m;
  return {
      {"circle of yield without strength",
       bearing(BiaxialBilinear{.yield_force = 0 * N, .yield_displacement = 1 * cm, .post_yield_stiffness = 1 * N / m}),
       {"PlanarSpring \"bearing\"", "yield_force", "0 N", "> 0 N and finite", "Check its sign and its unit"}},
      {"bouc-wen in plan without lead",
       bearing(BiaxialBoucWen{
           .characteristic_strength = 0 * N, .yield_displacement = 1 * cm, .post_yield_stiffness = 1 * N / m}),
       {"PlanarSpring \"bearing\"", "characteristic_strength", "0 N", "> 0 N and finite",
        "Check its sign and its unit"}},
      {"bouc-wen in plan that pushes away",
       bearing(BiaxialBoucWen{
           .characteristic_strength = 1 * N, .yield_displacement = 1 * cm, .post_yield_stiffness = -1 * N / m}),
       {"PlanarSpring \"bearing\"", "post_yield_stiffness", "-1 N/m", ">= 0 N/m and finite",
        "Check its sign and its unit"}},
      {"pendulum in plan without weight",
       bearing(BiaxialFrictionPendulum{FrictionPendulum::typical()}),
       {"PlanarSpring \"bearing\"", "weight", "0 N", "> 0 N and finite",
        "Give the weight on this bearing; a PlanBuilding knows its"}},
      {"rubber in plan without range",
       bearing(torn),
       {"PlanarSpring \"bearing\"", "b3", "0 1/m", "> 0 1/m and finite", "Check its sign and its unit"}},
      {"linear bearing in plan without stiffness",
       bearing(BiaxialLinear{.stiffness = 0 * N / m}),
       {"PlanarSpring \"bearing\"", "stiffness", "0 N/m", "> 0 N/m and finite", "Check its sign and its unit"}},
  };
}

}  // namespace moat::constructions
