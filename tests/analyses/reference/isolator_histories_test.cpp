// Histories of the building of the first tour on isolators of every kind, against an independent Runge-Kutta program
// with steps of 10 microseconds, converged to the digits given.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "analyses/integrators/exact_between_events.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "materials/contact/impact_laws.hpp"
#include "materials/spring_laws.hpp"
#include "motions/near_fault_pulse.hpp"
#include "peak_in.hpp"
#include "structures/moat.hpp"
#include "structures/shear_building.hpp"

namespace moat::testing {
namespace {

using namespace units;

ShearBuilding five_storeys(Isolation isolation) {
  return {.storeys = 5,
          .floor_mass = 500 * tonne,
          .storey_stiffness = 1 * GN / m,
          .damping = RayleighDamping{.ratio = 0.05},
          .base_mass = 550 * tonne,
          .isolation = std::move(isolation)};
}

const LeadRubberBearing lead_rubber{
    .yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};

struct Peaks {
  double base, top, base_acceleration, top_acceleration, isolation_force, drift;
};

CaseResult run(Model model, CaseOptions options = {}) {
  return run_case(model, near_fault_pulse({}).scaled_to_pga(0.4 * g), options);
}

// Everything within the tolerance; the acceleration of the base within its own.
void expect_peaks(const CaseResult& result, const Peaks& expected, double tolerance, double of_base_acceleration) {
  const auto near = [&](const std::string& quantity, const std::string& where, double value, double within) {
    EXPECT_NEAR(peak(result, quantity, where), value, within * value) << quantity << " " << where;
  };
  near("displacement", "base", expected.base, tolerance);
  near("displacement", "floor 5", expected.top, tolerance);
  near("absolute_acceleration", "base", expected.base_acceleration, of_base_acceleration);
  near("absolute_acceleration", "floor 5", expected.top_acceleration, tolerance);
  near("total_base_shear", "base", expected.isolation_force, tolerance);
  near("drift", "storey 1", expected.drift, tolerance);
}

// With settings that no run needs, all digits of the reference are met.
const CaseOptions tight{.transient = {.tolerance = 1e-8, .steps_per_contact = 1024}, .error_bars = ErrorBarMode::never};
constexpr double tight_tolerance = 1e-5;

CaseResult run_on(Isolation isolation, CaseOptions options = {}) {
  Model model;
  add(model, five_storeys(std::move(isolation)));
  return run(std::move(model), options);
}

TEST(IsolatorHistories, Bilinear) {
  const Peaks expected{.2975340, .3184525, 2.99793, 3.18616, 7.479407e6, 6.45644e-3};
  expect_peaks(run_on(lead_rubber), expected, 1e-3, 1e-3);
  expect_peaks(run_on(lead_rubber, tight), expected, tight_tolerance, tight_tolerance);
}

TEST(IsolatorHistories, BoucWen) {
  const Peaks expected{.2964644, .3171968, 2.93811, 3.13515, 7.458763e6, 6.42364e-3};
  expect_peaks(run_on(BoucWen::typical()), expected, 1e-3, 1e-3);
  expect_peaks(run_on(BoucWen::typical(), tight), expected, tight_tolerance, tight_tolerance);
}

TEST(IsolatorHistories, FrictionPendulum) {
  const Peaks expected{.282129, .295234, 3.102, 3.0463, 4.59047e6, 4.03783e-3};
  expect_peaks(run_on(FrictionPendulum::typical()), expected, 1e-3, 3e-3);
  // With half its steps the reference moved by 3e-4 in the acceleration of the base, which the top sees too.
  expect_peaks(run_on(FrictionPendulum::typical(), tight), expected, 5e-5, 3e-4);
}

TEST(IsolatorHistories, BilinearWithDamper) {
  NonlinearViscous damper{.reference_force = 1.5 * MN, .exponent = 0.3};
  const Peaks expected{.2642317, .2847643, 3.00999, 3.01812, 7.690683e6, 6.43311e-3};
  expect_peaks(run_on(Isolation{lead_rubber, damper}), expected, 1e-3, 1e-3);
  // The reference does not round the force at rest, which is worth 1e-4 with the default of 1 mm/s.
  damper.rounding_speed = 0.05 * mm / s;
  expect_peaks(run_on(Isolation{lead_rubber, damper}, tight), expected, tight_tolerance, tight_tolerance);
}

TEST(IsolatorHistories, BilinearWithDamperOnABrace) {
  const Isolation isolation{
      lead_rubber, MaxwellDamper{.brace_stiffness = 100 * MN / m, .reference_force = 1.5 * MN, .exponent = 0.3}};
  const Peaks expected{.2693972, .2906424, 3.44311, 3.58306, 7.849846e6, 6.67768e-3};
  expect_peaks(run_on(isolation), expected, 1e-3, 1e-3);
  expect_peaks(run_on(isolation, tight), expected, tight_tolerance, tight_tolerance);
}

TEST(IsolatorHistories, YieldingStoreys) {
  ShearBuilding building = five_storeys(lead_rubber);
  building.storey_stiffness = Stiffness{};
  building.storey = YieldingStorey{.stiffness = 1 * GN / m, .yield_force = 6 * MN, .hardening_ratio = 0.05};
  const Peaks expected{.2967548, .3184387, 2.99793, 3.18199, 7.464368e6, 9.32382e-3};
  Model model;
  add(model, building);
  expect_peaks(run(model), expected, 1e-3, 1e-3);
  expect_peaks(run(model, tight), expected, tight_tolerance, tight_tolerance);
}

// Without weakening the heated bearings are bilinear: eight of them share the layer.
TEST(IsolatorHistories, HeatedLeadRubberThatDoesNotWeaken) {
  HeatedLeadRubber law = HeatedLeadRubber::typical();
  law.strength = 1.737 * MN / 8.0;
  law.post_yield_stiffness = 19.3 * MN / m / 8.0;
  law.weakening = 0.0;
  expect_peaks(run_on(Isolator<HeatedLeadRubber>{.law = law, .count = 8}),
               {.2975340, .3184525, 2.99793, 3.18616, 7.479407e6, 6.45644e-3}, 1e-3, 1e-3);
}

// A mass on one bearing, m a = -F - m a_g, by Runge-Kutta's method with steps of 20 microseconds; the force and its
// state follow from their own rates, those of the steel from step to step.
TEST(IsolatorHistories, HeatedLeadRubberAgainstItsDifferentialEquations) {
  const HeatedLeadRubber law = HeatedLeadRubber::typical();
  const double mass = 150e3, k2 = .9e6, kd = 204.75e3 / .01, a = .06985, pi = 3.14159265358979;
  const double capacity = pi * a * a * 11200 * 130 * .2238;
  const auto strength = [](double t) { return 204.75e3 * std::exp(-.0069 * t); };
  const auto ground = [&](double t) { return t < 12 ? 4.0 * std::sin(pi * t / 12) * std::sin(2 * pi * t / 1.6) : 0.0; };
  struct Rates {
    double d, v, q, temperature;
  };
  constexpr double h = 2e-5;
  const SteelAroundLead steel{
      .rate = 50 / (a * 11200 * 130 * .2238), .time = a * a / 1.41e-5, .shims = 1.274 * .0714 / a};
  const SteelAroundLead::Step step_of_steel{steel, h};
  SteelAroundLead::Temperatures layers{};
  const auto rates = [&](double t, const Rates& y) {
    Rates rate{y.v, -(k2 * y.d + y.q) / mass - ground(t), kd * y.v, 0.0};
    const double limit = strength(y.temperature), cooling = steel.cooling(y.temperature, layers);
    rate.temperature = -cooling;
    if (std::abs(y.q) >= limit && y.q * y.v > 0.0) {
      // q = Q(T), and the slip grows by |v| - d|q|/kd: Q slip/capacity - cooling = dT, d|q| = per_kelvin dT.
      const double per_kelvin = -.0069 * limit, warming = limit / capacity;
      rate.temperature = (warming * std::abs(y.v) - cooling) / (1.0 + per_kelvin * warming / kd);
      rate.q = std::copysign(per_kelvin * rate.temperature, y.q);
    }
    return rate;
  };
  Rates y{};
  double largest_d = 0.0, largest_force = 0.0, largest_temperature = 0.0;
  const auto plus = [](const Rates& from, const Rates& k, double s) {
    return Rates{from.d + s * k.d, from.v + s * k.v, from.q + s * k.q, from.temperature + s * k.temperature};
  };
  for (int i = 0; i < static_cast<int>(14.0 / h); ++i) {
    const double t = i * h;
    const Rates k1 = rates(t, y), k2_ = rates(t + h / 2, plus(y, k1, h / 2)),
                k3 = rates(t + h / 2, plus(y, k2_, h / 2)), k4 = rates(t + h, plus(y, k3, h));
    const double before = y.temperature;
    y = plus(plus(plus(plus(y, k1, h / 6), k2_, h / 3), k3, h / 3), k4, h / 6);
    step_of_steel.advance(before, y.temperature, layers);
    const double limit = strength(y.temperature);
    if (std::abs(y.q) > limit) y.q = std::copysign(limit, y.q);
    largest_d = std::max(largest_d, std::abs(y.d));
    largest_force = std::max(largest_force, std::abs(k2 * y.d + y.q));
    largest_temperature = std::max(largest_temperature, y.temperature);
  }

  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = mass * kg});
  add(model, Isolator<HeatedLeadRubber>{.upper = node, .law = law});
  std::vector<double> samples;
  for (int i = 0; i <= 7000; ++i) samples.push_back(ground(0.002 * i));
  const CaseResult result = run_case(model, GroundMotion{"sine", 0.002, samples});
  EXPECT_NEAR(peak(result, "isolator_deformation", "bearings"), largest_d, 1e-3 * largest_d);
  EXPECT_NEAR(peak(result, "isolator_force", "bearings"), largest_force, 1e-3 * largest_force);
  EXPECT_NEAR(peak(result, "lead_temperature_rise", "bearings"), largest_temperature, 1e-3 * largest_temperature);
  EXPECT_GT(largest_temperature, 20.0);
}

// W = m g on R = 2 m with mu = 0.05, released at 0.45 m: every half cycle takes 2 mu R = 0.2 m.
TEST(IsolatorHistories, PendulumThatDecaysFreely) {
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = 100 * tonne, .initial_displacement = 0.45 * m});
  FrictionPendulum law{.radius = 2 * m, .friction = 0.05, .yield_displacement = 1e-3 * mm};
  law.weight = 100 * tonne * g;
  add(model, Isolator<FrictionPendulum>{.upper = node, .law = law});
  Transient analysis{model, GroundMotion{"rest", 0.01, std::vector<double>(600, 0.0)}};
  std::vector<double> turns, times;
  double before = 0.0, stopped = 0.0;
  while (!analysis.finished()) {
    analysis.advance();
    const double v = model.velocity(node);
    if (before * v < 0.0 && std::abs(before) > 1e-2) {
      turns.push_back(model.displacement(node));
      times.push_back(model.state().time);
    }
    if (std::abs(v) > 1e-2 || before == 0.0) before = v;
    if (stopped == 0.0 && model.state().time > 2.0 && std::abs(v) < 1e-3) stopped = model.state().time;
  }
  ASSERT_GE(turns.size(), 1U);
  EXPECT_NEAR(turns[0], -0.25, 1e-4);
  EXPECT_NEAR(times[0], 1.418746, 0.02);
  EXPECT_NEAR(stopped, 2.837491, 0.02);
  EXPECT_NEAR(model.displacement(node), 0.05, 1e-4);
}

TEST(IsolatorHistories, ExactStepsTakePendulumsOfOneFrictionAndRefuseLawsOfTime) {
  const FrictionPendulum pendulum{.radius = 3 * m, .friction = 0.06};
  CaseOptions exact;
  exact.transient.integrator = ExactBetweenEvents{};
  const CaseResult first = run_on(pendulum), second = run_on(pendulum, exact);
  for (const char* quantity : {"displacement", "absolute_acceleration"})
    EXPECT_NEAR(peak(second, quantity, "base"), peak(first, quantity, "base"), 1e-3 * peak(first, quantity, "base"));
  try {
    run_on(Isolation{lead_rubber, MaxwellDamper::typical()}, exact);
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(
        std::string{error.what()},
        "TransientOptions: integrator = ExactBetweenEvents{} needs elements that are linear between located events, "
        "and \"dampers\" is not. Use Newmark{}, or a law whose changes of stiffness are located.");
  }
}

// The energy of every law closes over a history.
TEST(IsolatorHistories, BalanceTheirEnergy) {
  const auto closes = [](const std::string& name, Isolation isolation, double tolerance) {
    const CaseResult result = run_on(std::move(isolation));
    EXPECT_LT(std::abs(result.energy.integration_error), tolerance * result.energy.largest_input) << name;
  };
  closes("BoucWen", BoucWen::typical(), 1e-3);
  closes("FrictionPendulum", FrictionPendulum::typical(), 1e-3);
  closes("TriplePendulum", TriplePendulum::typical(), 2e-3);
  closes("HeatedLeadRubber", Isolator<HeatedLeadRubber>{.law = HeatedLeadRubber::typical(), .count = 9}, 1e-3);
  closes("HeatedFrictionPendulum",
         Isolator<HeatedFrictionPendulum>{.law = HeatedFrictionPendulum::typical(), .count = 5}, 2e-3);
  closes("MaxwellDamper", Isolation{lead_rubber, MaxwellDamper::typical()}, 2e-3);
}

struct Row {
  const char *quantity, *where;
  double value;
};
void expect_rows(const CaseResult& result, const std::vector<Row>& rows, double tolerance, std::size_t touches) {
  for (const Row& row : rows)
    EXPECT_NEAR(peak(result, row.quantity, row.where), row.value, tolerance * row.value)
        << row.quantity << " " << row.where;
  EXPECT_EQ(result.impacts.size(), touches);
}

TEST(IsolatorHistories, BilinearAgainstFixedWalls) {
  Model model;
  const Building building = add(model, five_storeys(lead_rubber));
  add(model, Moat<HertzDamp>{.around = building.base,
                             .clearance = 10 * cm,
                             .law = {.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65}});
  const std::vector<Row> rows{{"displacement", "base", .1607108},         {"displacement", "floor 5", .3364880},
                              {"absolute_acceleration", "base", 54.0338}, {"absolute_acceleration", "floor 5", 53.2948},
                              {"isolator_force", "bearings", 4.838719e6}, {"drift", "storey 1", 42.1435e-3},
                              {"impact_force", "moat", 45.30874e6}};
  expect_rows(run(model), rows, 1e-3, 7U);
  expect_rows(run(model, tight), rows, tight_tolerance, 7U);
}

TEST(IsolatorHistories, BilinearAgainstWallsWithBackfill) {
  Model model;
  const Building building = add(model, five_storeys(lead_rubber));
  add(model, Moat<HertzDamp>{.around = building.base,
                             .clearance = 10 * cm,
                             .law = {.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65},
                             .wall = FlexibleWall{.mass = 60 * tonne,
                                                  .stiffness = 20 * MN / m,
                                                  .damping = 200 * kN * s / m,
                                                  .backfill = HyperbolicBackfill{.initial_stiffness = 203 * MN / m,
                                                                                 .ultimate_force = 3.26 * MN,
                                                                                 .failure_ratio = 0.7}}});
  const std::vector<Row> rows{{"displacement", "base", .3443992},
                              {"displacement", "floor 5", .3801240},
                              {"absolute_acceleration", "base", 13.8390},
                              {"absolute_acceleration", "floor 5", 9.05682},
                              {"isolator_force", "bearings", 8.383905e6},
                              {"drift", "storey 1", 13.8750e-3},
                              {"impact_force", "moat", 8.323373e6},
                              {"wall_deformation", "moat right wall", .2245508},
                              {"wall_deformation", "moat left wall", .1399121}};
  expect_rows(run(model), rows, 1e-3, 5U);
  expect_rows(run(model, tight), rows, tight_tolerance, 5U);
}

}  // namespace
}  // namespace moat::testing
