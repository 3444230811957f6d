// Warnings about energies that are not numbers, equations that do not balance, and strains beyond a fit.

#include "analyses/case/case_warnings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "analysis_testing.hpp"
#include "moat.hpp"
#include "small_models.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;

const TransientOptions adapted{}, fixed{.step = 5 * ms}, exact{.integrator = ExactBetweenEvents{}};

std::string only(const EnergyBalance& energy, const TransientOptions& options) {
  const std::vector<std::string> warnings = energy_warnings(energy, 1e-3, options);
  EXPECT_EQ(warnings.size(), 1u);
  return warnings.empty() ? "" : warnings.front();
}

TEST(EnergyWarnings, AreNotGivenWithoutReason) {
  EXPECT_TRUE(energy_warnings({}, 1e-3, adapted).empty());
  EXPECT_TRUE(
      energy_warnings({.equation_residual = 0.9, .integration_error = -0.9, .largest_input = 1e3}, 1e-3, adapted)
          .empty());
}

TEST(EnergyWarnings, ANumberThatIsNotFiniteIsNoGoodBalance) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  EXPECT_NE(only({.integration_error = nan, .largest_input = 1.0}, adapted).find("not a finite number"),
            std::string::npos);
  EXPECT_NE(only({.integration_error = 1.0, .largest_input = infinite}, adapted).find("not a finite number"),
            std::string::npos);
  EXPECT_NE(only({.equation_residual = nan, .largest_kinetic = 1.0}, adapted).find("not a finite number"),
            std::string::npos);
}

TEST(StrainWarnings, NameTheRubberBeyondItsFit) {
  const auto warnings = [](Length height) {
    Model model;
    const NodeId node = add(model, Node{.name = "floor", .mass = 100 * tonne});
    add(model, Isolator<KikuchiAikenRubber>{.upper = node, .law = {.area = 0.1 * m * m, .height = height}});
    std::string all;
    for (const std::string& each : run_case(model, near_fault_pulse({}).scaled_to_pga(0.4 * g)).warnings) all += each;
    return all;
  };
  EXPECT_NE(warnings(1 * cm).find("The strain of \"bearings\" reached "), std::string::npos);
  EXPECT_EQ(warnings(30 * cm).find("The strain"), std::string::npos);
}

// A slab of 100 t at 1 m/s has 50 kJ; a wall that yields at 100 kN and soil of at most 286 kN stop it after more than
// 50/386 m.
TEST(WallWarnings, NameWallsAndSoilBeyondTheirLimits) {
  const auto warnings = [](Force yield_force, Force ultimate_force) {
    Model model;
    const NodeId slab = add(model, Node{.name = "slab", .mass = 100 * tonne, .initial_velocity = 1 * m / s});
    add(model, Moat{.around = slab,
                    .clearance = 1 * mm,
                    .law = ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65},
                    .sides = Sides::right,
                    .wall = FlexibleWall{.mass = 5 * tonne,
                                         .stiffness = yield_force / (1 * mm),
                                         .yield_force = yield_force,
                                         .backfill = HyperbolicBackfill{.initial_stiffness = 100 * MN / m,
                                                                        .ultimate_force = ultimate_force}}});
    std::string all;
    for (const std::string& each : run_case(model, moat::testing::still_ground(2 * s)).warnings) all += each + "\n";
    return all;
  };
  const std::string weak = warnings(100 * kN, 200 * kN), strong = warnings(10 * MN, 20 * MN);
  EXPECT_NE(weak.find("\"moat wall\" was pushed to "), std::string::npos) << weak;
  EXPECT_NE(weak.find("\"moat wall backfill\" resists with "), std::string::npos) << weak;
  EXPECT_NE(weak.find("more than its ultimate_force of 200"), std::string::npos) << weak;
  EXPECT_EQ(strong.find("\"moat wall"), std::string::npos) << strong;
}

TEST(EnergyWarnings, ARunIntoInfinityWarns) {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 1e303 * kg});
  add(model, ShearSpring{.name = "spring", .lower = ground, .upper = body, .stiffness = 100 * N / m});
  // The kinetic energy of such a mass at such velocities is beyond the largest number.
  const GroundMotion motion{"far too strong", 0.01, std::vector<double>(101, 1e5)};
  const CaseResult result = run_case(model, motion, {.transient = fixed, .error_bars = ErrorBarMode::never});
  ASSERT_EQ(result.warnings.size(), 3u);
  EXPECT_NE(result.warnings[0].find("The model collapsed"), std::string::npos);
  EXPECT_NE(result.warnings[1].find("The peak acceleration of the ground is 10197.2 g"), std::string::npos);
  EXPECT_NE(result.warnings[2].find("An energy is not a finite number"), std::string::npos);
}

TEST(EnergyWarnings, EquationsThatDoNotBalanceWarn) {
  const EnergyBalance energy{.equation_residual = -2.0, .largest_input = 100.0};
  const std::string warning = only(energy, adapted);
  EXPECT_TRUE(
      warning.starts_with("The equations do not balance: work and kinetic energy are off by 2 % of the largest"))
      << warning;
}

TEST(EnergyWarnings, AdviceFitsTheKindOfSteps) {
  for (const EnergyBalance& energy : {EnergyBalance{.integration_error = 2.0, .largest_input = 100.0},
                                      EnergyBalance{.equation_residual = 2.0, .largest_input = 100.0}}) {
    EXPECT_NE(only(energy, fixed).find("Take a shorter step (now 0.005 s)"), std::string::npos);
    EXPECT_EQ(only(energy, fixed).find("tighter tolerance"), std::string::npos) << "it has none";
    EXPECT_NE(only(energy, adapted).find("Take a tighter tolerance (now 3e-05)"), std::string::npos);
    EXPECT_EQ(only(energy, adapted).find("shorter step"), std::string::npos) << "that would switch adapting off";
    EXPECT_NE(only(energy, exact).find("steps_per_contact"), std::string::npos);
    EXPECT_EQ(only(energy, exact).find("shorter step"), std::string::npos) << "exact steps refuse one";
    EXPECT_EQ(only(energy, exact).find("tighter tolerance"), std::string::npos)
        << "it has hardly an effect on energies";
    EXPECT_EQ(only(energy, {.tolerance = TransientOptions::least_tolerance}).find("tighter tolerance (now"),
              std::string::npos)
        << "there is none";
  }
}

TEST(ContactWarnings, AdviseMoreHalvingsWhereThereAreMore) {
  for (const bool most : {false, true}) {
    Model model = testing::body_before_wall(LinearElastic{.stiffness = (most ? 1e30 : 1e20) * N / m}, 1.0, 1.0, 0.01);
    const int halvings = most ? StepSettings::most_halvings : 16;
    const CaseResult result = run_case(model, testing::still_ground(0.02 * s),
                                       {.transient = {.max_halvings = halvings}, .error_bars = ErrorBarMode::never});
    std::string all;
    for (const std::string& each : result.warnings) all += each;
    EXPECT_NE(all.find("The shortest contact was divided into"), std::string::npos) << all;
    EXPECT_EQ(all.find("Raise TransientOptions::max_halvings") == std::string::npos, most) << all;
  }
}

TEST(EnergyWarnings, NameTheWorstElement) {
  EXPECT_NE(only({.integration_error = 2.0, .largest_input = 100.0, .worst_element = "storey 3"}, adapted)
                .find("most at \"storey 3\""),
            std::string::npos);
}

TEST(UnsettledWarning, SaysWhyAndWhatToDo) {
  ErrorBars bars{.checked = true, .companion_impacts = 8, .unsettled = true, .reason = "this differs"};
  const std::string pounding = unsettled_warning(bars, 7, adapted);
  EXPECT_TRUE(pounding.starts_with("The case is not settled: this differs. Take a tighter tolerance")) << pounding;
  EXPECT_NE(pounding.find("known to their error bars only"), std::string::npos);
  bars.companion_impacts = 0;
  EXPECT_EQ(unsettled_warning(bars, 0, fixed).find("Impacts"), std::string::npos);
}

TEST(PlanWarnings, OneLineIsEnoughForAllFloorsThatTurn) {
  Model model;
  std::vector<Peak> peaks;
  for (const char* name : {"low", "middle", "high"}) {
    add(model, Diaphragm{.name = name, .mass = 800 * tonne, .outline = rectangle(20 * m, 12 * m), .free = true});
    peaks.push_back({"rotation", name, peaks.size() == 1 ? 0.03 : 0.02, "rad", 1.0});
  }
  const Transient analysis{model, testing::still_ground(0.1 * s), {}};
  const std::vector<std::string> warnings = plan_warnings(analysis.state(), peaks, {});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(warnings[0].starts_with("The rotation of \"middle\" reached 0.03 rad.")) << warnings[0];
  EXPECT_NE(warnings[0].find(" mm, the most of 3 floors. "), std::string::npos) << warnings[0];
}

TEST(PlanWarnings, NameBearingsOutsideAndLargeRotations) {
  Model model;
  const DiaphragmId slab = add(
      model,
      Diaphragm{.name = "slab", .mass = 800 * tonne, .outline = rectangle(20 * m, 12 * m), .initial_rotation = 0.02});
  for (const double x : {-10.0, 10.5})
    for (const double y : {-6.0, 6.0})
      add(model,
          PlanBearing<BiaxialBilinear>{
              .name = "bearing " + std::to_string(x) + " " + std::to_string(y),
              .under = slab,
              .at = {x * m, y * m},
              .law = {.yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.6 * MN / m}});
  const CaseResult result = run_case(model, testing::still_ground(0.1 * s));
  int outside = 0, rotations = 0;
  for (const std::string& warning : result.warnings) {
    const std::string y = outside == 0 ? "-6" : "6";
    outside += warning == "Bearing \"bearing 10.500000 " + y + ".000000\" at (10.5, " + y +
                              ") m is outside the outline of \"slab\". Correct its position or the outline."
                   ? 1
                   : 0;
    // r theta^2/2 with r = 11.66 m.
    rotations += warning.find("at its corners they neglect 2.33") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(outside, 2);
  EXPECT_EQ(rotations, 1);
}

}  // namespace
}  // namespace moat
