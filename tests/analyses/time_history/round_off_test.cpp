// Round-off beside nothing is no error: directions that vanish by symmetry, bodies at rest, motions of almost nothing.

#include <gtest/gtest.h>

#include <cmath>

#include "analysis_testing.hpp"
#include "moat.hpp"
#include "paper_building.hpp"
#include "peak_in.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

GroundMotion pulse() {
  return near_fault_pulse({.pulse_period = 1.5 * s, .quiet_after = 4 * s}).scaled_to_pga(0.3 * g);
}

void expect_no_alarm(const CaseResult& result) {
  EXPECT_TRUE(result.error_bars.checked) << result.error_bars.companion;
  EXPECT_FALSE(result.error_bars.unsettled) << result.error_bars.reason;
  for (const std::string& warning : result.warnings) ADD_FAILURE() << warning;
}

CaseResult run(const Model& model, const GroundMotion& motion, const TransientOptions& options = {}) {
  return run_case(model, motion, {.transient = options, .error_bars = ErrorBarMode::always});
}

template <class Bearing>
Model tower(const Bearing& bearing, Length mass_offset = {}) {
  Model model;
  const auto building = add(model, PlanBuilding{.outline = rectangle(20 * m, 12 * m),
                                                .storeys = 2,
                                                .floor_mass = 700 * tonne,
                                                .mass_offset = {0 * m, mass_offset},
                                                .columns = grid(3, 2, {.stiffness = 100 * MN / m}),
                                                .damping = {.ratio = 0.05},
                                                .base_mass = 800 * tonne,
                                                .bearings = grid(3, 2, bearing)});
  add(model, PlanMoat{.around = building.base,
                      .clearance = 15 * cm,
                      .law = ExactHertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.6},
                      .friction = 0.4});
  return model;
}

BiaxialBoucWen bouc_wen() {
  return {.characteristic_strength = 184 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 2 * MN / m};
}

// --- Directions that vanish by symmetry

TEST(RoundOff, OfATowerThatMovesAlongOneAxisIsSettled) {
  for (const Angle incidence : {0 * deg, 90 * deg, 180 * deg, 270 * deg}) {
    SCOPED_TRACE(to_text(incidence / deg));
    const GroundMotion along = pulse();
    const GroundMotion motion = PlanMotion{along, along.scaled_by(0.0), incidence};
    const CaseResult result = run(tower(bouc_wen()), motion);
    EXPECT_GT(result.impacts.size(), 0u);
    EXPECT_LT(peak(result, "rotation", "floor 2"), 1e-12);
    expect_no_alarm(result);
  }
}

TEST(RoundOff, OfOtherBearingsInPlanIsSettled) {
  expect_no_alarm(run(tower(LeadRubberBearing{
                          .yield_force = 220 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 2 * MN / m}),
                      pulse()));
  expect_no_alarm(run(tower(FrictionPendulum{.radius = 3 * m, .friction = 0.05}), pulse()));
}

// A rotation of microradians is one.
TEST(RoundOff, DoesNotHideARotation) {
  const CaseResult result = run(tower(bouc_wen(), 0.1 * mm), pulse(), {.step = 20 * ms});
  EXPECT_LT(peak(result, "rotation", "floor 2"), 1e-4);
  bool rotation_is_unsettled = false;
  for (const Peak& each : result.error_bars.unsettled_peaks) rotation_is_unsettled |= each.quantity == "rotation";
  EXPECT_TRUE(rotation_is_unsettled) << result.error_bars.reason;
}

// --- Bodies at rest

// Under a constant acceleration of the ground, in the state in which its springs and walls carry it.
Model held(double acceleration, bool against_a_wall, double dashpot) {
  constexpr double mass = 5.5e5, stiffness = 1.7e7, contact = 2.95e9;
  Model model;
  double displacement = -mass * acceleration / stiffness;
  if (against_a_wall) {
    // The wall stands 5 cm before it would come to rest: k (0.05 + d) = f d^1.5 is solved by halving.
    double low = 0.0, high = std::abs(displacement);
    const double clearance = high - 0.05;
    for (int i = 0; i < 200; ++i) {
      const double d = 0.5 * (low + high);
      const double force = mass * std::abs(acceleration) - stiffness * (clearance + d) - contact * d * std::sqrt(d);
      (force > 0.0 ? low : high) = d;
    }
    displacement = -(clearance + low);
  }
  const NodeId body = add(model, Node{.name = "body", .mass = mass * kg, .initial_displacement = displacement * m});
  add(model, ShearSpring{.name = "spring", .lower = ground, .upper = body, .stiffness = stiffness * N / m});
  if (dashpot > 0.0)
    add(model, ViscousDamper{.name = "damper", .lower = ground, .upper = body, .damping = dashpot * N * s / m});
  if (against_a_wall)
    add(model, Gap{.name = "wall",
                   .left = ground,
                   .right = body,
                   .clearance = (mass * acceleration / stiffness - 0.05) * m,
                   .law = ExactHertzDamp{.stiffness = contact * N / m_3_2, .restitution = 0.65}});
  return model;
}

TEST(RoundOff, OfABodyAtRestUnderLoadRaisesNoAlarm) {
  for (const bool wall : {false, true})
    for (const double dashpot : {0.0, 3e5})
      for (const double acceleration : {3.0, 2.7182818284})
        for (const TransientOptions& options : {TransientOptions{}, TransientOptions{.step = 5 * ms},
                                                TransientOptions{.integrator = ExactBetweenEvents{}},
                                                TransientOptions{.integrator = HilberHughesTaylor{}, .step = 5 * ms}}) {
          SCOPED_TRACE(::testing::Message() << "wall " << wall << ", dashpot " << dashpot << ", acceleration "
                                            << acceleration << ", step " << options.step.si() << " s");
          const CaseResult result =
              run(held(acceleration, wall, dashpot), constant_acceleration(acceleration, 10 * s), options);
          expect_no_alarm(result);
          EXPECT_LT(peak(result, "velocity", "body"), 1e-9);
        }
}

// A force without a deformation.
struct Prestressed {
  using State = NoState;
  double force = 0.0, stiffness = 0.0;  // N, N/m

  Response evaluate(const State&, double d, double, State&) const { return {force + stiffness * d, stiffness, 0.0}; }
  double stored_energy(const State&, double d) const { return (force + 0.5 * stiffness * d) * d; }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return stiffness; }
};

TEST(RoundOff, OfABodyBetweenPrestressedSpringsRaisesNoAlarm) {
  for (const double force : {1e6, 0.7e9})
    for (const GroundMotion& motion : {still_ground(10 * s), pulse().scaled_by(1e-20)}) {
      SCOPED_TRACE(::testing::Message() << force << " N, " << motion.description());
      Model model;
      const NodeId body = add(model, Node{.name = "body", .mass = 5e5 * kg}),
                   other = add(model, Node{.name = "other", .mass = 3e5 * kg});
      const auto add_spring = [&](const char* name, NodeId lower, NodeId upper) {
        add(model, Spring<Prestressed>{
                       .name = name, .lower = lower, .upper = upper, .law = {.force = force, .stiffness = 3.3e7}});
      };
      // Each pulls its upper end down: from the ground over both bodies to the ground.
      add_spring("left", ground, body);
      add_spring("middle", body, other);
      add_spring("right", other, ground);
      expect_no_alarm(run(model, motion, {.step = 5 * ms}));
    }
}

// At rest without a motion, beside one that moves.
TEST(RoundOff, OfABodyBesideAMovingOneRaisesNoAlarm) {
  Model model;
  const NodeId body = add(model, Oscillator{.velocity = 0.3}), other = add(model, Oscillator{.name = "other"});
  add(model, Gap{.name = "gap", .left = body, .right = other, .clearance = 20 * cm, .law = paper_hertz_damp()});
  expect_no_alarm(run(model, still_ground(5 * s)));
}

// --- Motions of almost nothing

TEST(RoundOff, OfMotionsOfAlmostNothingRaisesNoAlarm) {
  for (const GroundMotion& motion :
       {still_ground(4 * s), pulse().scaled_by(1e-20), pulse().scaled_by(1e-12), pulse().scaled_by(1e-160)}) {
    SCOPED_TRACE(motion.description());
    expect_no_alarm(run(pounding_building(), motion));
    expect_no_alarm(run(pounding_building(), motion, {.integrator = ExactBetweenEvents{}}));
    expect_no_alarm(run(tower(bouc_wen()), motion));
    expect_no_alarm(run(tower(FrictionPendulum{.radius = 3 * m, .friction = 0.05}), motion));
  }
  // An analysis that ends before its motion begins.
  expect_no_alarm(run(pounding_building(), pulse(), {.end = 1.3 * s}));
}

// A body at rest under load, and a motion of a billionth of the load.
TEST(RoundOff, OfAVibrationFarBelowTheLoadRaisesNoAlarm) {
  for (const double share : {1e-9, 1e-12, 1e-15}) {
    SCOPED_TRACE(share);
    const GroundMotion load =
        sampled("load", 10 * s, 10 * ms, [&](double t) { return 3.0 + 3.0 * share * std::sin(3.0 * t); });
    const CaseResult result = run(held(3.0, false, 3e5), load);
    for (const std::string& warning : result.warnings) EXPECT_EQ(warning.find("balance"), std::string::npos) << warning;
    EXPECT_FALSE(result.error_bars.unsettled) << result.error_bars.reason;
  }
}

}  // namespace
}  // namespace moat
