// The peaks of quantities that laws report lie between steps like those of the deformation.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "moat.hpp"
#include "moat_model.hpp"
#include "peak_in.hpp"
#include "random_draws.hpp"
#include "random_motion.hpp"

namespace moat {
namespace {

using namespace units;
using testing::peak;

// A body on a spring with the law, on the ground, so that its deformation contains the motion of the ground inside the
// steps.
template <class Law>
CaseResult run_on_ground(const Law& law, Mass mass, std::uint64_t seed, Integrator integrator = Newmark{}) {
  testing::RandomDraws draws{seed};
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = mass});
  add(model, Spring<Law>{.name = "law", .lower = ground, .upper = body, .law = law});
  return run_case(model, testing::moat_motion(testing::random_motion(draws)),
                  {.transient = {.integrator = integrator}, .error_bars = ErrorBarMode::never});
}

constexpr double round_off = 1e-12;

template <class Law>
void expect_shares_of_deformation(const Law& law, Mass mass, const std::string& quantity, double length,
                                  Integrator integrator = Newmark{}) {
  SCOPED_TRACE(Law::name);
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const CaseResult result = run_on_ground(law, mass, seed, integrator);
    EXPECT_NEAR(peak(result, quantity) * length / peak(result, "deformation"), 1.0, round_off);
  }
}

TEST(DuctilityPeak, IsThatOfTheDriftOverTheYieldDrift) {
  const YieldingStorey yielding{.stiffness = 40 * MN / m, .yield_force = 0.4 * MN};
  expect_shares_of_deformation(yielding, 500 * tonne, "ductility", 0.01);
  expect_shares_of_deformation(yielding, 500 * tonne, "ductility", 0.01, ExactBetweenEvents{});
  const BaberNoori baber_noori = BaberNoori::typical();
  expect_shares_of_deformation(baber_noori, 1000 * tonne, "ductility", baber_noori.yield_drift.si());
  const ImkBilinear imk = ImkBilinear::typical();
  expect_shares_of_deformation(imk, 1000 * tonne, "ductility", imk.yield_force.si() / imk.stiffness.si());
}

TEST(ShearStrainPeak, IsThatOfTheDeformationOverTheHeight) {
  const KikuchiAikenRubber rubber = KikuchiAikenRubber::typical();
  expect_shares_of_deformation(rubber, 100 * tonne, "shear_strain", rubber.height.si());
}

// mu grows with the speed: its peak is that at the largest one.
TEST(FrictionPeak, IsThatAtTheLargestSpeed) {
  const FrictionPendulum pendulum{.radius = 2 * m,
                                  .friction = VelocityDependent{.slow = 0.03, .fast = 0.06, .rate = 2.0 * s / m}};
  const Mass mass = 100 * tonne;
  const auto law = pendulum.carrying(mass * g);
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const CaseResult result = run_on_ground(law, mass, seed);
    const double expected = 0.06 - 0.03 * std::exp(-2.0 * peak(result, "velocity"));
    EXPECT_NEAR(peak(result, "friction_coefficient") / expected, 1.0, TransientOptions{}.tolerance);
  }
}

// Where a slide ends, mu has its value at rest: the slip is less than the deformation by mu_slow/mu_fast times the
// elastic move. Both are largest at the same turn.
TEST(SlipPeak, IsThatAtTheEndOfASlide) {
  constexpr double slow = 0.03, fast = 0.06;
  const Length elastic_move = 1 * cm;
  const FrictionPendulum pendulum{.radius = 2.5 * m,
                                  .friction = VelocityDependent{.slow = slow, .fast = fast, .rate = 100.0 * s / m},
                                  .yield_displacement = elastic_move};
  const Mass mass = 100 * tonne;
  const auto law = pendulum.carrying(mass * g);
  int slid = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const CaseResult result = run_on_ground(law, mass, seed);
    const double deformation = peak(result, "deformation");
    if (deformation < 3.0 * elastic_move.si()) continue;
    ++slid;
    EXPECT_NEAR(peak(result, "isolator_slip"), deformation - slow / fast * elastic_move.si(),
                TransientOptions{}.tolerance * deformation);
    // The slip runs back at first, while mu grows faster than the body moves. This is no loss of energy.
    EXPECT_LT(std::abs(result.energy.integration_error), 5e-4 * result.energy.largest_input);
  }
  EXPECT_GT(slid, 4);
}

}  // namespace
}  // namespace moat
