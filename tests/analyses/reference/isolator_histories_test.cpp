// Histories of the building of the first tour on isolators of every kind, against an independent Runge-Kutta program
// with steps of 10 microseconds, converged to the digits given.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analysis_testing.hpp"
#include "message_of.hpp"
#include "moat.hpp"
#include "peak_in.hpp"

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

CaseResult run(const Model& model, CaseOptions options = {}) {
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

TEST(IsolatorHistories, OfIsolators) {
  struct Case {
    Isolation isolation;
    Peaks expected;
    double of_base_acceleration, tight, tight_of_base_acceleration;  // tolerances
  };
  const MaxwellDamper on_a_brace{.brace_stiffness = 100 * MN / m, .reference_force = 1.5 * MN, .exponent = 0.3};
  // With half its steps the reference of the pendulum moved by 3e-4 in the acceleration of the base, which the top sees
  // too.
  for (const Case& each :
       {Case{lead_rubber, {.2975340, .3184525, 2.99793, 3.18616, 7.479407e6, 6.45644e-3}, 1e-3, 1e-5, 1e-5},
        Case{BoucWen::typical(), {.2964644, .3171968, 2.93811, 3.13515, 7.458763e6, 6.42364e-3}, 1e-3, 1e-5, 1e-5},
        Case{FrictionPendulum::typical(), {.282129, .295234, 3.102, 3.0463, 4.59047e6, 4.03783e-3}, 3e-3, 5e-5, 3e-4},
        Case{Isolation{lead_rubber, on_a_brace},
             {.2693972, .2906424, 3.44311, 3.58306, 7.849846e6, 6.67768e-3},
             1e-3,
             1e-5,
             1e-5}}) {
    SCOPED_TRACE(each.expected.base);
    expect_peaks(run_on(each.isolation), each.expected, 1e-3, each.of_base_acceleration);
    expect_peaks(run_on(each.isolation, tight), each.expected, each.tight, each.tight_of_base_acceleration);
  }
}

TEST(IsolatorHistories, BilinearWithDamper) {
  NonlinearViscous damper{.reference_force = 1.5 * MN, .exponent = 0.3};
  const Peaks expected{.2642317, .2847643, 3.00999, 3.01812, 7.690683e6, 6.43311e-3};
  expect_peaks(run_on(Isolation{lead_rubber, damper}), expected, 1e-3, 1e-3);
  // The reference does not round the force at rest, which is worth 1e-4 with the default of 1 mm/s.
  damper.rounding_speed = 0.05 * mm / s;
  expect_peaks(run_on(Isolation{lead_rubber, damper}, tight), expected, tight_tolerance, tight_tolerance);
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

TEST(IsolatorHistories, ExactStepsTakePendulumsOfOneFrictionAndRefuseLawsOfTime) {
  const FrictionPendulum pendulum{.radius = 3 * m, .friction = 0.06};
  CaseOptions exact;
  exact.transient.integrator = ExactBetweenEvents{};
  const CaseResult first = run_on(pendulum), second = run_on(pendulum, exact);
  for (const char* quantity : {"displacement", "absolute_acceleration"})
    EXPECT_NEAR(peak(second, quantity, "base"), peak(first, quantity, "base"), 1e-3 * peak(first, quantity, "base"));
  EXPECT_EQ(
      message_of([&] {
        run_on(Isolation{lead_rubber, MaxwellDamper::typical()}, exact);
      }),
      "TransientOptions: integrator = ExactBetweenEvents{} needs elements that are linear between located events, "
      "and \"dampers\" is not. Use Newmark{}, or a law whose changes of stiffness are located.");
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

// The heat of a lead core is of second order in the length of steps.
// The displacement after seven seconds of a sine that slides again and again.
double displacement_with(Time step) {
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = 150 * tonne});
  add(model, Isolator<HeatedLeadRubber>{.upper = node, .law = HeatedLeadRubber::typical()});
  constexpr double pi = std::numbers::pi;
  const GroundMotion motion = sampled(
      "sine", 7 * s, 10 * ms, [](double t) { return 4.0 * std::sin(pi * t / 12.0) * std::sin(2.0 * pi * t / 1.6); });
  Transient analysis{model, motion, {.step = step}};
  while (!analysis.finished()) analysis.advance();
  return analysis.state().displacement(node);
}

TEST(HeatedLeadRubber, IsOfSecondOrderInTheStep) {
  const double exact = displacement_with(0.25 * ms);
  const double coarse = displacement_with(8 * ms) - exact, middle = displacement_with(4 * ms) - exact,
               fine = displacement_with(2 * ms) - exact;
  EXPECT_NEAR(std::log2(coarse / middle), 2.0, 0.2);
  EXPECT_NEAR(std::log2(middle / fine), 2.0, 0.2);
}

}  // namespace
}  // namespace moat::testing
