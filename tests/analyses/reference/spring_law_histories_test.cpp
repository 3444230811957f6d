// Every law of isolators, dampers, storeys and soil in analyses with default settings: against very short explicit
// steps, and in the buildings of the building layer.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "moat.hpp"
#include "peak_in.hpp"
#include "random_spring.hpp"

namespace moat::testing {
namespace {

using namespace units;

// A mass on a law and a spring, in very short explicit steps: no code of elements, events or integrators of moat.
struct OscillatorPeaks {
  double displacement = 0.0, acceleration = 0.0, force = 0.0;  ///< m, m/s^2 absolute, N of the law
};

/// m a = -F - k u - m a_g(t) from rest.
struct ReferenceOscillator {
  double mass = 0.0, spring = 0.0;  ///< kg, N/m
  double interval = 0.01;           ///< s, between samples
  std::vector<double> ground{};     ///< m/s^2, linear between samples, 0 behind the last

  /// Position Verlet steps, of second order while the law is smooth: u half a step, the force at its end with the
  /// speed there, u the other half. Regimes change at the first step that is beyond their margin.
  template <ForceLaw Law>
  [[nodiscard]] OscillatorPeaks follow(const Law& law, int steps_per_interval) const {
    const double h = interval / steps_per_interval;
    typename Law::State state{}, trial;
    double u = 0.0, v = 0.0, at = 0.0, rate_there = 0.0;
    OscillatorPeaks peaks;
    for (std::size_t i = 0; i + 1 < ground.size(); ++i)
      for (int k = 0; k < steps_per_interval; ++k) {
        const double share = (k + 0.5) / steps_per_interval;
        const double a_g = ground[i] + share * (ground[i + 1] - ground[i]);
        const double middle = u + 0.5 * h * v;
        if constexpr (LawWithRegimes<Law>)
          for (int changes = 0; changes < 4 && law.regime_margin(state, middle, v) < 0.0; ++changes)
            state = law.next_regime(state, middle, v);
        // The law at the middle of the step; its dashpot with the mean speed of the step, by iteration.
        double speed = v, force = 0.0, acceleration = 0.0;
        for (int pass = 0; pass < 3; ++pass) {
          force = respond(law, state, middle, speed, {h, at, rate_there}, trial).force;
          acceleration = -(force + spring * middle) / mass - a_g;
          speed = v + 0.5 * h * acceleration;
        }
        state = trial;
        at = middle;
        rate_there = speed;
        v += h * acceleration;
        u = middle + 0.5 * h * v;
        peaks.displacement = std::max(peaks.displacement, std::abs(middle));
        peaks.acceleration = std::max(peaks.acceleration, std::abs(acceleration + a_g));
        peaks.force = std::max(peaks.force, std::abs(force));
      }
    return peaks;
  }
};

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
