// Energies that are not numbers and equations that do not balance are told of, with advice that can be followed.

#include "analyses/case_warnings.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "analyses/case_run.hpp"
#include "analysis_testing.hpp"
#include "elements/shear_spring.hpp"

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

TEST(EnergyWarnings, ARunIntoInfinityWarns) {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 1 * kg});
  add(model, ShearSpring{.name = "spring", .lower = ground, .upper = body, .stiffness = 100 * N / m});
  // The squares of such velocities are beyond the largest number.
  const GroundMotion motion{"far too strong", 0.01, std::vector<double>(101, 1e200)};
  const CaseResult result = run_case(model, motion, {.transient = fixed, .error_bars = ErrorBarMode::never});
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_NE(result.warnings[0].find("An energy is not a finite number"), std::string::npos);
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
    EXPECT_EQ(only(energy, exact).find("tighter tolerance"), std::string::npos) << "it has no effect outside contact";
  }
}

TEST(EnergyWarnings, NameTheWorstElement) {
  EXPECT_NE(only({.integration_error = 2.0, .largest_input = 100.0, .worst_element = "storey 3"}, adapted)
                .find("most at \"storey 3\""),
            std::string::npos);
}

TEST(SensitivityWarning, SaysWhyAndWhatToDo) {
  ErrorBars bars{.checked = true, .companion_impacts = 8, .sensitive = true, .reason = "this differs"};
  const std::string pounding = sensitivity_warning(bars, 7, adapted);
  EXPECT_TRUE(pounding.starts_with("The case is sensitive: this differs. Take a tighter tolerance")) << pounding;
  EXPECT_NE(pounding.find("known to their error bars only"), std::string::npos);
  bars.companion_impacts = 0;
  EXPECT_EQ(sensitivity_warning(bars, 0, fixed).find("Impacts"), std::string::npos);
}

}  // namespace
}  // namespace moat
