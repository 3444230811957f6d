// Where the energy goes, against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis_testing.hpp"
#include "moat.hpp"
#include "paper_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

double total(const EnergyBalance& e) { return e.kinetic + e.strain + e.viscous + e.hysteretic + e.impact; }

TEST(EnergyBalance, InputUnderConstantGroundAccelerationIsForceTimesWay) {
  Model model;
  add(model, Node{.name = "free", .mass = 3 * kg, .free = true});
  const CaseResult result = run_case(model, constant_acceleration(2.0, 1 * s), {.transient = {.step = 10 * ms}});
  // u = - a t^2 / 2 = -1 m under - m a = -6 N.
  EXPECT_NEAR(result.energy.input, 6.0, 1e-9);
  EXPECT_NEAR(result.energy.kinetic, 6.0, 1e-9);
  EXPECT_NEAR(result.energy.equation_residual, 0.0, 1e-12);
}

TEST(EnergyBalance, ADashpotTakesWhatADecayingVibrationLoses) {
  Model model;
  const NodeId mass = add(model, Node{.name = "mass", .mass = 1 * kg, .initial_displacement = 1 * m});
  const double omega = 2.0 * std::numbers::pi, ratio = 0.05;
  add(model, Spring<Linear>{.name = "spring",
                            .lower = ground,
                            .upper = mass,
                            .law = {.stiffness = omega * omega * N / m, .damping = 2 * ratio * omega * kg / s}});
  double previous_error = 0.0;
  for (const double step : {0.02, 0.01}) {
    const CaseResult result = run_case(model, still_ground(10 * s), {.transient = {.step = step * s}});
    const EnergyBalance& e = result.energy;
    EXPECT_EQ(e.input, 0.0);
    // Nearly all of 1/2 k d0^2 is dissipated after ten periods: e^(-2 ratio omega t) remains.
    const double remaining = std::exp(-2.0 * ratio * omega * 10.0);
    EXPECT_NEAR(e.viscous, 0.5 * omega * omega * (1.0 - remaining), 0.5 * omega * omega * (0.01 + remaining));
    EXPECT_NEAR(e.kinetic + e.strain + e.viscous + e.integration_error, 0.0, 1e-11);
    EXPECT_NEAR(e.equation_residual, 0.0, 1e-11);
    // c h (v1 - v0)^2 / 12 per step: second order.
    if (previous_error != 0.0) {
      EXPECT_NEAR(order(previous_error, e.integration_error), 2.0, 0.05);
    }
    previous_error = e.integration_error;
    EXPECT_EQ(e.worst_element, "spring");
  }
}

TEST(EnergyBalance, AnImpactLosesOneMinusTheSquareOfItsRestitution) {
  for (const double e : {0.2, 0.65, 0.95}) {
    Model model = body_before_wall(ExactHertzDamp{.stiffness = 2.95e9 * N / m_3_2, .restitution = e}, 5.5e5, 0.5, 0.05);
    const CaseResult result = run_case(model, still_ground(2 * s), {});
    const double approach_energy = 0.5 * 5.5e5 * 0.25;
    ASSERT_EQ(result.impacts.size(), 1u);
    EXPECT_NEAR(result.impacts[0].energy_lost, approach_energy * (1 - e * e), 1e-3 * approach_energy);
    EXPECT_NEAR(result.impacts[0].restitution, e, 1e-8);
    EXPECT_NEAR(result.impacts[0].rebound_ratio, e, 1e-3);
    EXPECT_EQ(result.energy.impact, result.impacts[0].energy_lost);
    ASSERT_EQ(result.energy.gaps.size(), 1u);
    EXPECT_EQ(result.energy.gaps[0].where, "wall");
  }
}

TEST(EnergyBalance, ClosesForABuildingThatYieldsAndPounds) {
  for (const bool locate : {false, true}) {
    SCOPED_TRACE(locate ? "yield located" : "yield stepped over");
    ShearBuilding building = paper_building();
    if (!locate) building.isolation = unlocated_paper_bearings();
    Model model = pounding_building(10 * cm, building);
    const CaseResult result = run_case(model, sine_motion(4.0, 3.5, 6 * s), {});
    const EnergyBalance& e = result.energy;
    ASSERT_FALSE(result.impacts.empty());
    EXPECT_GT(e.hysteretic, 0.0);
    // Velocities of fourth order: the residual is far below the tolerance of the steps, not round-off.
    EXPECT_LT(std::abs(e.equation_residual), 1e-5 * e.largest_input);
    EXPECT_LT(std::abs(e.integration_error), 1e-3 * e.largest_input);
    EXPECT_NEAR(total(e) + e.integration_error - e.equation_residual, e.input, 1e-12 * e.largest_input);
    double lost = 0.0;
    for (const Impact& impact : result.impacts) lost += impact.energy_lost;
    EXPECT_NEAR(lost, e.impact, 1e-9 * e.impact);
  }
}

TEST(EnergyBalance, AWarningNamesTheWorstElement) {
  Model model = pounding_building();
  const CaseResult result = run_case(model, sine_motion(4.0, 3.5, 6 * s),
                                     {.transient = {.step = 40 * ms}, .error_bars = ErrorBarMode::never});
  ASSERT_EQ(result.warnings.size(), 3u);
  EXPECT_NE(result.warnings[0].find("does not divide the motion's interval"), std::string::npos);
  EXPECT_NE(result.warnings[1].find("fixed step divides the shortest contact"), std::string::npos);
  EXPECT_NE(result.warnings[2].find("most at \"" + result.energy.worst_element + "\""), std::string::npos);
}

}  // namespace
}  // namespace moat
