#include "moat.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis_testing.hpp"
#include "law_cases.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;
using std::numbers::pi;

// The amplification matrix of one step of an undamped oscillator for (u, h v, h^2 a), for angular frequency times step
// `wh`: the numbers of the integrator, put into the equations of step_scheme.hpp by hand.
Eigen::Matrix3d amplification(const Integrator& integrator, double wh) {
  const StepScheme scheme = scheme_of(integrator).value();
  const double w2 = wh * wh;
  Eigen::Matrix3d matrix;
  for (int column = 0; column < 3; ++column) {
    const Eigen::Vector3d start = Eigen::Vector3d::Unit(column);
    const double predicted_u = start[0] + start[1] + (0.5 - scheme.beta) * start[2];
    const double predicted_v = start[1] + (1.0 - scheme.gamma) * start[2];
    const double a = -((1.0 - scheme.mass_share) * start[2] +
                       w2 * (scheme.force_share * predicted_u + (1.0 - scheme.force_share) * start[0])) /
                     (scheme.mass_share + scheme.force_share * scheme.beta * w2);
    matrix.col(column) << predicted_u + scheme.beta * a, predicted_v + scheme.gamma * a, a;
  }
  return matrix;
}

double spectral_radius(const Integrator& integrator, double wh) {
  return amplification(integrator, wh).eigenvalues().cwiseAbs().maxCoeff();
}

TEST(Integrators, GeneralizedAlphaHasItsSpectralRadiusAtInfiniteFrequency) {
  for (const double radius : {0.0, 0.3, 0.8, 1.0})
    EXPECT_NEAR(spectral_radius(GeneralizedAlpha{.spectral_radius = radius}, 1e6), radius, 2e-3) << radius;
}

TEST(Integrators, HilberHughesTaylorHasItsSpectralRadiusAtInfiniteFrequency) {
  for (const double alpha : {0.0, -0.1, -0.3})
    EXPECT_NEAR(spectral_radius(HilberHughesTaylor{.alpha = alpha}, 1e6), (1.0 + alpha) / (1.0 - alpha), 2e-3) << alpha;
}

TEST(Integrators, NoneGrowsAtAnyFrequency) {
  const std::vector<Integrator> all{Newmark::average_acceleration(), HilberHughesTaylor{.alpha = -0.2},
                                    GeneralizedAlpha{.spectral_radius = 0.5}};
  for (const Integrator& integrator : all)
    for (double wh = 1e-3; wh < 1e4; wh *= 1.7)
      EXPECT_LT(spectral_radius(integrator, wh), 1.0 + 1e-7) << name_of(integrator) << " at " << wh;
}

TEST(Integrators, AnAnalysisDoesWhatTheNumbersSay) {
  const double step = 0.01;
  for (const double wh : {0.3, 100.0})
    for (const Integrator& integrator :
         std::vector<Integrator>{HilberHughesTaylor{.alpha = -0.2}, GeneralizedAlpha{.spectral_radius = 0.0},
                                 GeneralizedAlpha{.spectral_radius = 0.5}, GeneralizedAlpha{.spectral_radius = 1.0}}) {
      Model model = oscillator({.frequency = wh / step, .displacement = 0.01});
      Transient analysis{model, still_ground(1 * s, step * s), {.integrator = integrator, .step = step * s}};
      const Eigen::Matrix3d matrix = amplification(integrator, wh);
      Eigen::Vector3d expected{0.01, 0.0, -wh * wh * 0.01};
      for (int i = 0; i < 12; ++i) {
        analysis.advance();
        expected = matrix * expected;
        EXPECT_NEAR(analysis.state().displacement(NodeId{0}), expected[0], 1e-6 * 0.01)
            << name_of(integrator) << ", step " << i + 1;
      }
    }
}

enum class Part { linear, bilinear, contact };

// Relative accelerations of the floor of an isolated building at the samples of a pulse.
std::vector<double> accelerations(Part part, const TransientOptions& options) {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne}),
               floor = add(model, Node{.name = "floor", .mass = 900 * tonne});
  add(model, ShearSpring{.name = "storey", .lower = base, .upper = floor, .stiffness = 0.5 * GN / m});
  add(model, ViscousDamper{.name = "damper", .lower = base, .upper = floor, .damping = 1.5 * MN * s / m});
  if (part == Part::linear)
    add(model, ShearSpring{.name = "bearing", .lower = ground, .upper = base, .stiffness = 12 * MN / m});
  else
    add(model,
        LeadRubberBearing{
            .upper = base, .yield_force = 1.2 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 9 * MN / m});
  if (part == Part::contact) add(model, Moat{.around = base, .clearance = 12 * cm, .law = paper_hertz_damp()});
  const GroundMotion motion = near_fault_pulse({.quiet_after = 1 * s}).scaled_to_pga(0.4 * g);
  Transient analysis{model, motion, options};
  std::vector<double> found;
  Watch watch{[&](const StepView& view) {
    const double sample = view.state.time() / motion.time_step();
    if (view.on_grid && std::abs(sample - std::round(sample)) < 1e-6) found.push_back(view.state.acceleration(floor));
  }};
  analysis.attach(watch);
  analysis.run();
  return found;
}

// The unknown of an averaged equation is of first order; the acceleration of the results is not.
TEST(Integrators, AccelerationsOfAlphaMethodsAreOfSecondOrder) {
  for (const Part part : {Part::linear, Part::bilinear, Part::contact}) {
    const std::vector<double> exact =
        accelerations(part, {.tolerance = 1e-9, .steps_per_contact = 1024, .largest_step = 1 * ms});
    for (const Integrator& integrator :
         std::vector<Integrator>{HilberHughesTaylor{.alpha = -0.05}, HilberHughesTaylor{.alpha = -1.0 / 3.0},
                                 GeneralizedAlpha{.spectral_radius = 0.0}, GeneralizedAlpha{.spectral_radius = 0.8},
                                 GeneralizedAlpha{.spectral_radius = 1.0}}) {
      const auto error = [&](Time step) {
        const std::vector<double> found = accelerations(part, {.integrator = integrator, .step = step});
        EXPECT_EQ(found.size(), exact.size());
        double squares = 0.0;
        for (std::size_t i = 0; i < std::min(found.size(), exact.size()); ++i)
          squares += (found[i] - exact[i]) * (found[i] - exact[i]);
        return std::sqrt(squares);
      };
      EXPECT_GT(order(error(0.5 * ms), error(0.25 * ms)), 1.9)
          << name_of(integrator) << ", part " << static_cast<int>(part);
    }
  }
}

TEST(Integrators, TheLedgerShowsTheEnergyThatAnIntegratorRemoves) {
  const double step = 0.05;
  Model model = oscillator({.mass = 1000.0, .displacement = 0.01});
  EnergyLedger ledger;
  Transient analysis{
      model, still_ground(5 * s, step * s), {.integrator = GeneralizedAlpha{.spectral_radius = 0.2}, .step = step * s}};
  analysis.attach(ledger);
  analysis.run();
  const EnergyBalance balance = ledger.balance(analysis.state());
  const double start = 0.5 * 1000.0 * 4.0 * pi * pi * 1e-4;
  const double removed = -(balance.kinetic + balance.strain);
  EXPECT_GT(removed, 0.05 * start);
  EXPECT_NEAR(-balance.equation_residual, removed, 1e-9 * start);
}

TEST(Integrators, AreFoundByName) {
  EXPECT_EQ(integrator_named("newmark"), Integrator{Newmark{}});
  EXPECT_EQ(integrator_named("hht-alpha"), Integrator{HilberHughesTaylor{}});
  EXPECT_EQ(integrator_named("generalized-alpha"), Integrator{GeneralizedAlpha{}});
  EXPECT_EQ(integrator_named("exact-between-events"), Integrator{ExactBetweenEvents{}});
  EXPECT_EQ(integrator_named("automatic"), Integrator{Automatic{}});
  EXPECT_EQ(message_of([] { integrator_named("wilson-theta"); }),
            "integrator: \"wilson-theta\" is not known. Give one of: newmark, hht-alpha, generalized-alpha, "
            "exact-between-events, automatic.");
}

}  // namespace
}  // namespace moat
