// Touch and separation inside steps: located, in order, never missed, never stalling.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis_testing.hpp"
#include "moat.hpp"
#include "paper_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

constexpr HertzStiffness concrete = 2.95e9 * N / m_3_2;

void add_wall(Model& model, const std::string& name, NodeId body, Length clearance, double restitution = 1.0,
              HertzStiffness stiffness = concrete) {
  add(model, Gap<HertzDamp>{.name = name,
                            .left = body,
                            .right = ground,
                            .clearance = clearance,
                            .law = {.stiffness = stiffness, .restitution = restitution}});
}

// A free body of 550 t that moves with a speed, m/s, to a wall a clearance of so many m away.
Model body_before(double speed, double clearance, double restitution = 1.0) {
  return body_before_wall(HertzDamp{.stiffness = concrete, .restitution = restitution}, 550e3, speed, clearance);
}

// Keeps the opening of every gap and the time at the instants just before an event.
struct EventLog final : StepObserver {
  struct Entry {
    double time;
    std::string gap;
    double opening;  // m, negative while indented
    bool touching;   // afterwards
  };
  std::vector<Entry> entries;

  void start(const StepView&) override {}
  void step(const StepView&) override {}
  void event(const StepView& view, std::span<const RegimeChange> changes) override {
    for (const RegimeChange& change : changes) {
      const ElementStates& gaps = view.state.elements(change.block);
      entries.push_back({view.state.time(), view.model.blocks()[change.block]->info(change.element).name,
                         -gaps.results()[change.element].deformation, gaps.contact(change.element).touching});
    }
  }
  void finish(const StepView&) override {}
};

TEST(ContactEvents, TouchAndSeparationAreLocatedToTheTolerance) {
  for (const double tolerance : {1e-12, 1e-9, 1e-6}) {
    Model model = body_before(0.4, 0.01234, 0.65);
    EventLog log;
    Transient analysis{model, still_ground(0.4 * s), {.step = 5 * ms, .location_tolerance = tolerance * m}};
    analysis.attach(log);
    analysis.run();
    ASSERT_EQ(log.entries.size(), 2u) << tolerance;
    EXPECT_TRUE(log.entries[0].touching);
    EXPECT_FALSE(log.entries[1].touching);
    for (const auto& entry : log.entries) EXPECT_LE(std::abs(entry.opening), tolerance) << entry.time;
    // Just beyond: closed at touch, open at separation.
    EXPECT_LT(log.entries[0].opening, 0.0);
    EXPECT_GT(log.entries[1].opening, 0.0);
    EXPECT_NEAR(log.entries[0].time, 0.01234 / 0.4, tolerance / 0.4);
    EXPECT_EQ(analysis.statistics().events, 2);
  }
}

// A dashpot behind a wall: its force jumps from nothing to damping * speed at the touch.
struct DashpotWall {
  double damping = 0.0;  // N s/m

  using State = ContactState;

  Response evaluate(const State& committed, double, double rate, State& trial) const {
    trial = committed;
    if (committed.phase != ContactPhase::loaded) return {};
    return {damping * rate, 0.0, damping};
  }
  double stored_energy(const State&, double) const { return 0.0; }
  double dissipation_rate(const State& committed, double, double rate) const {
    return committed.phase == ContactPhase::loaded ? damping * rate * rate : 0.0;
  }
  double linear_stiffness(StiffnessStage) const { return 0.0; }
  double regime_margin(const State& committed, double indentation, double) const {
    return committed.phase == ContactPhase::open ? -indentation : indentation;
  }
  State next_regime(const State& committed, double, double rate) const {
    return committed.phase == ContactPhase::open ? State{ContactPhase::loaded, rate} : State{};
  }
  double contact_duration(double mass, double) const { return mass / damping; }
};

constexpr double dashpot_mass = 1000.0, dashpot_speed = 2.0, dashpot_damping = 5000.0;

// A free body that runs into the dashpot at t = 5.15 ms and is slowed down: v = v0 exp(-c t / m) from then on.
Model body_before_dashpot() {
  Model model;
  const NodeId body =
      add(model, Node{.name = "body", .mass = dashpot_mass * kg, .initial_velocity = dashpot_speed * m / s});
  model.block<LinkBlock<DashpotWall>>().add({.name = "dashpot",
                                             .place = "dashpot",
                                             .first = ground,
                                             .second = body,
                                             .force_quantity = "impact_force",
                                             .offset = 0.0103},
                                            DashpotWall{dashpot_damping}, dashpot_mass);
  return model;
}

// In a long step the margin beyond a separation or an unloading is far from straight.
TEST(ContactEvents, AreLocatedInFewSolvesInLongSteps) {
  for (const double length : {2.5e-3, 5e-3}) {
    SCOPED_TRACE(length);
    Model model = pounding_building();
    const PeaksAndImpacts run = compute_peaks(model, near_fault_pulse().scaled_to_pga(0.4 * g), {.step = length * s});
    ASSERT_GT(run.touches.size(), 5u);
    EXPECT_LT(run.solver.event_solves, 4 * run.solver.events);
  }
}

TEST(ContactEvents, AForceThatJumpsKeepsSecondOrder) {
  const auto error = [](double step) {
    Model model = body_before_dashpot();
    Transient analysis{model, still_ground(0.4 * s), {.step = step * s}};
    analysis.run();
    const double since_touch = 0.4 - 0.0103 / dashpot_speed;
    return std::abs(analysis.state().velocity(NodeId{0}) -
                    dashpot_speed * std::exp(-dashpot_damping / dashpot_mass * since_touch));
  };
  EXPECT_NEAR(order(error(0.004), error(0.002)), 2.0, 0.1);
}

TEST(ContactEvents, GridTimesAreKeptAfterAnEvent) {
  Model model = body_before(0.4, 0.01234);
  std::vector<double> grid;
  Watch watch{[&](const StepView& view) {
    if (view.on_grid) grid.push_back(view.state.time());
  }};
  Transient analysis{model, still_ground(0.4 * s), {.step = 5 * ms}};
  analysis.attach(watch);
  analysis.run();
  ASSERT_EQ(grid.size(), 81u);
  for (std::size_t i = 0; i < grid.size(); ++i) EXPECT_DOUBLE_EQ(grid[i], 0.005 * static_cast<double>(i));
}

TEST(ContactEvents, TwoGapsThatCloseInOneStepDoSoInOrder) {
  // Both walls are reached within one step of 50 ms, the nearer body's first although it was added last.
  Model model;
  const NodeId slow = add(model, Node{.name = "slow", .mass = 550 * tonne, .initial_velocity = 0.4 * m / s});
  const NodeId fast = add(model, Node{.name = "fast", .mass = 550 * tonne, .initial_velocity = 0.8 * m / s});
  add_wall(model, "wall of slow", slow, 1.2 * cm);
  add_wall(model, "wall of fast", fast, 1.2 * cm);
  EventLog log;
  Transient analysis{model, still_ground(60 * ms), {.step = 50 * ms}};
  analysis.attach(log);
  analysis.run();
  ASSERT_GE(log.entries.size(), 2u);
  EXPECT_EQ(log.entries[0].gap, "wall of fast");
  EXPECT_NEAR(log.entries[0].time, 0.015, 1e-11);
  EXPECT_EQ(log.entries[1].gap, "wall of slow");
  EXPECT_NEAR(log.entries[1].time, 0.03, 1e-11);
  EXPECT_TRUE(log.entries[0].touching && log.entries[1].touching);
}

TEST(ContactEvents, ACrossingThatReversesWithinOneStepIsFound) {
  // A ball thrown against a constant acceleration turns 2 mm behind where the wall stands, all within a step of
  // 0.2 s: free flight u = v t - g t^2 / 2 has its top v^2 / (2 g) at t = v / g.
  const double speed = 0.5, pull = 5.0, top = speed * speed / (2.0 * pull);
  Model model = body_before(speed, top - 0.002);
  EventLog log;
  Transient analysis{model, constant_acceleration(pull, 0.2 * s, 0.2 * s), {.step = 200 * ms}};
  analysis.attach(log);
  analysis.advance();
  ASSERT_EQ(log.entries.size(), 1u);
  EXPECT_TRUE(log.entries[0].touching);
  const double touch = (speed - std::sqrt(2.0 * pull * 0.002)) / pull;
  EXPECT_NEAR(log.entries[0].time, touch, 1e-10);
  EXPECT_NEAR(analysis.state().velocity(NodeId{0}), speed - pull * touch, 1e-9);
}

TEST(ContactEvents, ACrossingThatReversesIsFoundBesideOneThatEndsInTheBand) {
  // In the first step `slow` ends half a millimetre beyond its wall, which a band of 3 mm takes for located, while
  // `quick` swings through its own wall and back.
  Model model;
  const NodeId slow = add(model, Node{.name = "slow", .mass = 1 * tonne, .initial_velocity = 0.1 * m / s});
  add_wall(model, "slow wall", slow, 0.5 * mm);
  const NodeId quick = add(model, Node{.name = "quick", .mass = 1 * tonne, .initial_velocity = 1 * m / s});
  constexpr double frequency = 283.0;
  add(model, Spring<Linear>{.name = "spring",
                            .lower = ground,
                            .upper = quick,
                            .law = {.stiffness = 1000.0 * frequency * frequency * N / m}});
  add_wall(model, "quick wall", quick, 3.45 * mm);
  EventLog log;
  Transient analysis{model, still_ground(0.1 * s), {.step = 10 * ms, .location_tolerance = 3 * mm}};
  analysis.attach(log);
  while (log.entries.empty() || log.entries.back().gap != "quick wall") analysis.advance();
  EXPECT_TRUE(log.entries.back().touching);
  EXPECT_LT(log.entries.back().time, 10e-3);
}

TEST(ContactEvents, AnAlmostCrossingWithinOneStepIsNone) {
  const double speed = 0.5, pull = 5.0, top = speed * speed / (2.0 * pull);
  Model model = body_before(speed, top + 1e-6);
  const CaseResult result =
      run_case(model, constant_acceleration(pull, 0.2 * s, 0.2 * s), {.transient = {.step = 200 * ms}});
  EXPECT_TRUE(result.impacts.empty());
  EXPECT_EQ(result.solver.accepted_steps, 1);
}

TEST(ContactEvents, AGrazingTouchDoesNotStall) {
  // The top of the flight is the wall's face to within a few tolerances, on either side.
  const double speed = 0.5, pull = 5.0, top = speed * speed / (2.0 * pull);
  for (const double beyond : {-1e-9, -1e-12, 0.0, 1e-15, 1e-13, 1e-12, 1e-11, 1e-9, 1e-7})
    for (const double step : {0.001, 0.0073, 0.1, 0.2}) {
      Model model = body_before(speed, top - beyond, 0.65);
      SCOPED_TRACE(::testing::Message() << beyond << " m beyond, step " << step << " s");
      const auto [result, state] =
          run_to_end(model, constant_acceleration(pull, 0.2 * s, 0.2 * s), {.transient = {.step = step * s}});
      EXPECT_LE(result.impacts.size(), 1u);
      EXPECT_LT(result.solver.accepted_steps, 0.2 / step + 20.0);
      // Whether it counts as a touch or not, the body flies back as it came.
      EXPECT_NEAR(state.velocity(NodeId{0}), speed - pull * 0.2, 2e-3);
      EXPECT_TRUE(state.motion().displacement.allFinite());
    }
}

TEST(ContactEvents, ABodyThatBouncesOnItsWallDoesNotChatter) {
  // No dashpot: every bounce returns a part of the speed until the contact is not left any more.
  for (const double restitution : {0.9, 0.65, 0.3, 0.05}) {
    Model model = body_before(0.0, 0.01, restitution);
    const auto [result, state] =
        run_to_end(model, constant_acceleration(-3.0, 10 * s), {.transient = {.step = 2.5 * ms}});
    EXPECT_TRUE(state.motion().displacement.allFinite());
    EXPECT_GT(state.displacement(NodeId{0}), -1.0) << restitution;
    EXPECT_LT(state.displacement(NodeId{0}), 0.03) << restitution;
    // Bounces lose energy: no later one is faster than the first.
    for (const Impact& impact : result.impacts)
      EXPECT_LT(impact.approach_speed, 1.001 * result.impacts.front().approach_speed);
  }
}

TEST(ContactEvents, ATouchWithoutSpeedDoesNotDivideByZero) {
  // At rest a hair from the wall, then pressed: approach speed is (almost) nothing.
  for (const double clearance : {1e-15, 1e-9, 1e-6}) {
    Model model = body_before(0.0, clearance, 0.65);
    const auto [result, state] = run_to_end(model, constant_acceleration(-0.1, 1 * s), {.transient = {.step = 1 * ms}});
    ASSERT_GE(result.impacts.size(), 1u) << clearance;
    // The touch is located within a picometre beyond the face.
    EXPECT_GE(result.impacts.front().approach_speed, 0.999 * std::sqrt(2.0 * 0.1 * clearance));
    EXPECT_LE(result.impacts.front().approach_speed, 1.001 * std::sqrt(2.0 * 0.1 * (clearance + 1e-12)));
    EXPECT_TRUE(state.motion().displacement.allFinite());
    EXPECT_TRUE(state.motion().velocity.allFinite());
    EXPECT_LT(state.displacement(NodeId{0}), 0.01);
  }
}

TEST(ContactEvents, ADampedContactThatStartsClosedAtRestIsTheWayBackOfAnImpact) {
  // v0 is the speed at which an elastic impact reaches the depth. With w = -d'/v0, m d'' = -k d^1.5 (1 + z d'/v0) from
  // rest integrates to -w/z - ln(1 - z w)/z^2 = 1/2 at the end, for any k, m and depth.
  const double mass = 1000.0, stiffness = 1e9;
  for (const double restitution : {0.3, 0.5, 0.9})
    for (const double depth : {1e-4, 1e-3, 1e-2}) {
      SCOPED_TRACE(std::to_string(restitution) + ", " + std::to_string(depth) + " m");
      const double z = damping_factor_of_viscous_hertz(restitution);
      double low = 0.0, high = std::min(1.0, 1.0 / z);
      for (int i = 0; i < 200; ++i) {
        const double w = 0.5 * (low + high);
        (-w / z - std::log1p(-z * w) / (z * z) < 0.5 ? low : high) = w;
      }
      const double stored = 0.4 * stiffness * std::pow(depth, 2.5);
      const double speed = low * std::sqrt(2.0 * stored / mass);

      Model model;
      const NodeId body =
          add(model, Node{.name = "body", .mass = mass * kg, .initial_displacement = 1 * cm + depth * m, .free = true});
      add(model, Gap<ExactHertzDamp>{.name = "wall",
                                     .left = body,
                                     .right = ground,
                                     .clearance = 1 * cm,
                                     .law = {.stiffness = stiffness * N / m_3_2, .restitution = restitution}});
      const auto [result, state] = run_to_end(model, still_ground(0.5 * s));
      EXPECT_NEAR(-state.velocity(NodeId{0}), speed, 1e-3 * speed);  // default steps in contact
      EXPECT_NEAR(result.energy.impact, stored - 0.5 * mass * speed * speed, 2e-3 * stored);
      EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
      ASSERT_EQ(result.impacts.size(), 1u);
      EXPECT_EQ(result.impacts.front().approach_speed, 0.0);
    }
}

// The interpolant of a step may see a touch and return where the shorter solved step sees none.
TEST(ContactEvents, AWallAtThePeakOfAVibrationNeverStopsTheAnalysis) {
  for (const double closeness : {1e-4, 1e-6, 1e-8}) {
    for (int i = -20; i <= 20; ++i) {
      Model model;
      const NodeId body = add(model, Oscillator{.mass = 1000.0, .frequency = 10.0, .velocity = 1.0});
      add(model, Gap<HertzDamp>{.name = "gap",
                                .left = body,
                                .right = ground,
                                .clearance = 0.1 * (1.0 + closeness * i / 20.0) * m,
                                .law = {.stiffness = 1e9 * N / m_3_2, .restitution = 0.65}});
      Transient analysis{model, still_ground(2 * s), {.step = 10 * ms}};
      EXPECT_NO_THROW(analysis.run()) << closeness << " " << i;
    }
  }
}

}  // namespace
}  // namespace moat
