// A heavy body that is held in balance does not take the accuracy of a light one beside it.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis_testing.hpp"
#include "moat.hpp"
#include "peak_in.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

constexpr double ground_acceleration = 2.0;                              // m/s^2
constexpr double light_mass = 10.0, frequency = 4.0 * std::numbers::pi;  // kg, 1/s

// The light body starts at rest: u = -(a/w^2) (1 - cos wt).
constexpr double peak = 2.0 * ground_acceleration / (frequency * frequency);

// Bodies that no element joins have runs of their own. These two have one.
void join(Model& model, NodeId left, NodeId right) {
  add(model, Gap{.name = "far apart",
                 .left = left,
                 .right = right,
                 .clearance = 1 * km,
                 .law = LinearElastic{.stiffness = 1e6 * N / m}});
}

// Of the light body's peak displacement, relative.
double error(double mass_ratio, const TransientOptions& options) {
  Model model;
  const NodeId heavy = add(model, Oscillator{.name = "heavy",
                                             .mass = mass_ratio * light_mass,
                                             .frequency = frequency,
                                             .displacement = -ground_acceleration / (frequency * frequency)});
  const NodeId light = add(model, Oscillator{.name = "light", .mass = light_mass, .frequency = frequency});
  join(model, heavy, light);
  const CaseResult result = run_case(model, constant_acceleration(ground_acceleration, 2 * s),
                                     {.transient = options, .error_bars = ErrorBarMode::never});
  EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
  return testing::peak(result, "displacement", "light") / peak - 1.0;
}

TEST(UncoupledMasses, TheLightBodyIsAsAccurateAsAlone) {
  // The error of the period, a fraction of the tolerance, does not reach a peak that is an amplitude; the remaining
  // error is far below the tolerance. At the force tolerance of the whole model the light body would be off by 1e-8
  // mass_ratio.
  for (const double mass_ratio : {1.0, 1e4, 1e6, 1e8, 1e9, 1e10}) {
    SCOPED_TRACE(mass_ratio);
    EXPECT_LT(std::abs(error(mass_ratio, {})), TransientOptions{}.tolerance);
    EXPECT_LT(std::abs(error(mass_ratio, {.tolerance = 1e-6})), 1e-6);
    // Average acceleration conserves the amplitude; three samples around the peak miss it by (w h)^4/64 at most.
    EXPECT_LT(std::abs(error(mass_ratio, {.step = 1 * ms})), std::pow(frequency * 1e-3, 4) / 64.0 + 1e-7);
  }
}

// On a force that is not linear, so that the residual decides when the iteration ends.
TEST(UncoupledMasses, TheEquationOfTheLightBodyBalances) {
  constexpr double square = frequency * frequency, mass = 1000.0;  // kg
  for (const double mass_ratio : {1.0, 1e6, 1e8}) {
    SCOPED_TRACE(mass_ratio);
    Model model;
    const NodeId heavy = add(model, Oscillator{.name = "heavy",
                                               .mass = mass_ratio * mass,
                                               .frequency = frequency,
                                               .displacement = -ground_acceleration / square});
    const NodeId light = add(model, Oscillator{.name = "light", .mass = mass, .frequency = frequency});
    add(model, Isolator<BoucWen>{
                   .name = "bearing",
                   .upper = light,
                   .law = {.yield_force = 300 * N, .yield_displacement = 2 * mm, .post_yield_stiffness = 15 * kN / m}});
    join(model, heavy, light);
    const CaseResult result = run_case(model, constant_acceleration(ground_acceleration, 4 * s),
                                       {.transient = {.step = 5 * ms}, .error_bars = ErrorBarMode::never});
    // The heavy body does not move, so that the energy is that of the light one.
    EXPECT_LT(std::abs(result.energy.equation_residual), 1e-7 * result.energy.largest_input);
  }
}

}  // namespace
}  // namespace moat
