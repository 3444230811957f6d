// Every law of isolators, dampers, storeys and soil in analyses with default settings: against very short explicit
// steps, and in the buildings of the building layer.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "base/units.hpp"
#include "elements/line/isolator.hpp"
#include "elements/line/spring.hpp"
#include "materials/linear.hpp"
#include "materials/spring_laws.hpp"
#include "motions/near_fault_pulse.hpp"
#include "motions/plan_motion.hpp"
#include "peak_in.hpp"
#include "random_spring.hpp"
#include "reference_oscillator.hpp"
#include "structures/plan_building.hpp"
#include "structures/shear_building.hpp"

namespace moat::testing {
namespace {

using namespace units;

// A mass of 2 s on the secant stiffness of the law at its natural deformation D, with a spring of 1.5 times that beside
// it, so that P-delta and dampers come back too; the ground moves it by about D.
template <ForceLaw Law>
ReferenceOscillator oscillator_on(const Law& law) {
  constexpr double pi = std::numbers::pi, omega = 2.0 * pi / 2.0;
  const double deformation = natural_deformation(law), secant = std::abs(secant_stiffness(law, deformation));
  ReferenceOscillator oscillator{.mass = 2.5 * secant / (omega * omega), .spring = 1.5 * secant};
  const double strongest = 0.8 * omega * omega * deformation;
  for (int i = 0; i <= 600; ++i) {
    const double t = i * oscillator.interval;
    oscillator.ground.push_back(t < 5.0 ? strongest * std::sin(pi * t / 5.0) * std::sin(1.1 * omega * t) : 0.0);
  }
  return oscillator;
}

template <ForceLaw Law>
OscillatorPeaks default_peaks(const Law& law, const ReferenceOscillator& oscillator) {
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = oscillator.mass * kg});
  add(model, Isolator<Law>{.upper = node, .law = law});
  add(model,
      Spring<Linear>{
          .name = "spring", .lower = ground, .upper = node, .law = Linear{.stiffness = oscillator.spring * N / m}});
  const CaseResult result = run_case(model, GroundMotion{"sine", oscillator.interval, oscillator.ground});
  return {peak(result, "displacement", "mass"), peak(result, "absolute_acceleration", "mass"),
          peak(result, "isolator_force", "bearings")};
}

TEST(EverySpringLaw, FollowsVeryShortStepsWithDefaultSettings) {
  AllSpringLaws::for_each([]<class Law>() {
    for_random_laws<Law>(2, [](const auto& law) {
      const ReferenceOscillator oscillator = oscillator_on(law);
      const OscillatorPeaks fine = oscillator.follow(law, 100), finer = oscillator.follow(law, 200),
                            computed = default_peaks(law, oscillator);
      const auto near = [](double value, double expected, double of_reference, double scale) {
        EXPECT_NEAR(value, expected, 1e-3 * scale + 4.0 * std::abs(of_reference - expected));
      };
      near(computed.displacement, finer.displacement, fine.displacement, finer.displacement);
      near(computed.force, finer.force, fine.force, finer.force);
      near(computed.acceleration, finer.acceleration, fine.acceleration, 3.0 * finer.acceleration);
    });
  });
}

constexpr double share_of_energy = 1e-2;

void expect_sound_case(const CaseResult& result) {
  for (const Peak& each : result.peaks) EXPECT_TRUE(std::isfinite(each.value)) << each.quantity << " " << each.where;
  EXPECT_LT(std::abs(result.energy.integration_error), share_of_energy * result.energy.largest_input);
}

const GroundMotion pulse = near_fault_pulse({}).scaled_to_pga(0.4 * g);
const LeadRubberBearing lead_rubber{
    .yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};

ShearBuilding two_storeys() {
  return {.storeys = 2,
          .floor_mass = 1250 * tonne,
          .storey_stiffness = 1 * GN / m,
          .damping = RayleighDamping{.ratio = 0.05},
          .base_mass = 550 * tonne,
          .isolation = lead_rubber};
}

// Alone if it carries weight, else beside lead-rubber bearings; its quantities are among the peaks.
TEST(EverySpringLaw, ActsUnderABuilding) {
  AllSpringLaws::for_each([]<class Law>() {
    SCOPED_TRACE(Law::name);
    ShearBuilding building = two_storeys();
    if constexpr (WeightBearing<Law>)
      building.isolation = Law::typical();
    else
      building.isolation = Isolation{lead_rubber, Law::typical()};
    Model model;
    add(model, building);
    const CaseResult result = run_case(model, pulse);
    expect_sound_case(result);
    for (const ReportedQuantity& each : quantities_of(force_law(Law::typical()))) {
      const bool found =
          std::ranges::any_of(result.peaks, [&](const Peak& peak) { return peak.quantity == each.name; });
      EXPECT_TRUE(found) << each.name;
    }
  });
}

TEST(EverySpringLaw, ActsInAStorey) {
  AllSpringLaws::for_each([]<class Law>() {
    if constexpr (ForceLaw<Law>) {
      if (Law::typical().linear_stiffness(StiffnessStage::initial) <= 0.0) return;
      SCOPED_TRACE(Law::name);
      ShearBuilding building = two_storeys();
      building.floor_mass = 50 * tonne;
      building.base_mass = 55 * tonne;
      building.storey_stiffness = Stiffness{};
      building.storey = Law::typical();
      Model model;
      add(model, building);
      expect_sound_case(run_case(model, pulse));
    }
  });
}

// Along x a building in plan is the chain of the same floors.
TEST(PlanBuilding, StandsOnBearingsThatHaveALawInPlan) {
  const auto expect_same = [](const auto& bearing, Isolation chain, double tolerance) {
    Model line, plan;
    ShearBuilding shear = two_storeys();
    shear.damping = RayleighDamping{.ratio = 0.0};
    shear.isolation = std::move(chain);
    add(line, shear);
    add(plan, PlanBuilding{.outline = rectangle(20 * m, 12 * m),
                           .storeys = 2,
                           .floor_mass = 1250 * tonne,
                           .columns = grid(2, 2, {.stiffness = 250 * MN / m}),
                           .base_mass = 550 * tonne,
                           .bearings = grid(2, 2, bearing)});
    const CaseResult expected = run_case(line, pulse),
                     computed = run_case(plan, PlanMotion{pulse, pulse.scaled_by(0.0), 0.0 * deg});
    EXPECT_NEAR(peak(computed, "displacement_x", "base"), peak(expected, "displacement", "base"),
                tolerance * peak(expected, "displacement", "base"));
  };
  expect_same(FrictionPendulum::typical(), FrictionPendulum::typical(), 2e-3);
  expect_same(lead_rubber,
              Isolator<Bilinear>{.law = Bilinear{lead_rubber.yield_force, lead_rubber.yield_displacement,
                                                 lead_rubber.post_yield_stiffness},
                                 .count = 4},
              2e-3);
}

}  // namespace
}  // namespace moat::testing
