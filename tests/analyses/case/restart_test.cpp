// A run that is saved at any moment goes on from there bit for bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "block_on_bearings.hpp"
#include "message_of.hpp"
#include "moat.hpp"
#include "output/recorders/isolator_forces.hpp"
#include "plane_frames.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;

const ExactHertzDamp hard{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65};

LeadRubberBearing lead_rubber(Force yield_force = 1.93 * MN) {
  return {.yield_force = yield_force, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};
}

GroundMotion pulse() { return near_fault_pulse({.quiet_after = 1.5 * s}).scaled_to_pga(0.5 * g); }

// A case, and the treatment of its runs.
struct Restarted {
  Model model{};
  GroundMotion motion = pulse();
  CaseOptions options{};
  bool pounds = true;  // for certain
  bool checks_bearings = false;
};

template <class Isolation>
Model in_moat(const Isolation& isolation) {
  Model model;
  const auto building = add(model, ShearBuilding{.storeys = 2,
                                                 .floor_mass = 500 * tonne,
                                                 .storey_stiffness = 1 * GN / m,
                                                 .damping = RayleighDamping{.ratio = 0.05},
                                                 .base_mass = 550 * tonne,
                                                 .isolation = isolation});
  add(model, Moat{.around = building.base, .clearance = 8 * cm, .law = hard});
  return model;
}

Restarted on_line(TransientOptions transient) {
  transient.end = 6 * s;
  return {.model = in_moat(lead_rubber()), .options = {.transient = transient}};
}
Restarted with_error_bars() {
  Restarted each = on_line({});
  each.options.error_bars = ErrorBarMode::always;
  each.options.contact_sensitivity = ContactSensitivityMode::always;
  each.options.history_interval = 7 * ms;  // rows inside steps
  return each;
}

Restarted with_strong_dashpot() {
  Restarted each = on_line({});
  Model& model = each.model;
  const NodeId tank = add(model, Node{.name = "tank", .mass = 5 * tonne});
  add(model, ShearSpring{.name = "leg", .lower = model.buildings()[0].base, .upper = tank, .stiffness = 20 * MN / m});
  add(model,
      ViscousDamper{.name = "strut", .lower = model.buildings()[0].base, .upper = tank, .damping = 30 * MN * s / m});
  return each;
}

template <class Law>
Restarted on(const Law& law, int count) {
  return {.model = in_moat(Isolator<Law>{.law = law, .count = count}), .pounds = false};
}

// A block on heating pendulums whose friction follows the weight, which lifts from them.
Restarted on_changing_weight() {
  return {.model = testing::block_on(HeatedFrictionPendulum::typical(), 2.0, 1, false,
                                     {.vertical_period = 0.1 * s, .vertical_damping = 0.05}),
          .motion = testing::shaking_along_and_up(2.0, 8.0),
          .options = {.transient = {.end = 4 * s}},
          .pounds = false};
}

// Corners slide along walls, with friction; the checks of its bearings have a recorder.
Restarted in_plan() {
  Restarted each{.checks_bearings = true};
  PlanBuilding building = testing::small_plan_building(
      1, {.yield_force = 250 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 2 * MN / m});
  building.mass_offset = PlanPosition{1 * m, 0.6 * m};
  building.damping = {.ratio = 0.05};
  const auto tower = add(each.model, building);
  add(each.model, PlanMoat{.around = tower.base, .clearance = 12 * cm, .law = hard, .friction = 0.4});
  each.motion = PlanMotion{pulse(), pulse().scaled_by(0.6)};
  return each;
}

Restarted of_frame(double damping_ratio = 0.02) {
  Restarted each;
  const MemberSection section{.area = 0.02 * m_2, .I_y = 8e-4 * m_4, .I_z = 8e-4 * m_4};
  Frame frame = testing::plane_frame(
      {.storeys = {3.6 * m, 3.6 * m}, .bay = 6 * m, .bays = 1, .columns = {section}, .beam = section});
  for (FrameLevel& level : frame.levels) level.mass = 50 * tonne;
  const auto building = add(
      each.model,
      Superstructure{.condensed = frame.condensed(),
                     .damping = ModalDamping{damping_ratio},
                     .base = SuperstructureBase{.mass = 55 * tonne},
                     .isolation = LeadRubberBearing{
                         .yield_force = 110 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1 * MN / m}});
  add(each.model, Moat{.around = building.base, .clearance = 8 * cm, .law = hard});
  return each;
}

struct StepCounter final : QuantityRecorder {
  std::vector<OfferedQuantity> quantities() const override { return {{"steps", "run", "1"}}; }
  void step(const StepView&) override { ++steps; }
  void sample(const StepView&, std::span<double> values) const override { values[0] = steps; }
  void archive(StateArchive& archive) override { archive(steps); }
  double steps = 0.0;
};

// The case with recorders of all kinds.
struct Run {
  explicit Run(const Restarted& given) : run{given.model, given.motion, given.options}, forces{given.model} {
    if (given.checks_bearings) {
      std::map<std::string, BearingCapacities> all;
      for (const auto& block : given.model.blocks())
        for (const ElementInfo& info : block->infos())
          if (info.isolates) all[info.name] = {.displacement_capacity = 0.3 * m};
      run.attach(checks.emplace(CheckRules::none, all));
    }
    run.attach(forces);
    run.attach(counter);
  }

  // All numbers of its results, as bytes.
  std::string results() {
    CaseResult result = run.result();
    StateArchive bytes;
    bytes(result.peaks, result.clearances, result.impacts, result.contact_sensitivity, result.warnings,
          result.assumptions);
    for (Column& column : result.histories.columns) bytes(column.values);
    for (FloorSpectrum& each : result.floor_spectra) bytes(each.spectrum.pseudo_acceleration);
    for (BearingCheckRow& row : result.bearing_checks) bytes(row.demand.demand, row.demand.time);
    std::vector<Peak> largest_forces = forces.peaks();
    bytes(largest_forces);
    EnergyBalance& energy = result.energy;
    bytes(energy.input, energy.weight_work, energy.kinetic, energy.strain, energy.viscous, energy.hysteretic,
          energy.impact, energy.friction, energy.equation_residual, energy.integration_error, energy.largest_input,
          energy.largest_kinetic, energy.round_off, energy.worst_element, energy.worst_element_error);
    for (const auto* places : {&energy.bearings, &energy.gaps})
      for (DissipatedEnergy each : *places) bytes(each.value);
    for (SolverStatistics* each : {&result.solver, &result.error_bars.companion_solver}) {
      each->cpu_seconds = 0.0;
      bytes(*each);
    }
    return bytes.take();
  }

  CaseRun run;
  IsolatorForces forces;
  StepCounter counter;
  std::optional<BearingCheckRecorder> checks;
};

// Chooses the moments at which a run is saved: a quarter of them within contacts, if it pounds.
std::vector<int> moments_of(const Restarted& given) {
  Run one{given};
  std::vector<int> in_contact, others, chosen;
  int moment = 0;
  one.run.stop_when([&] {
    const bool touches =
        !one.run.transient().finished() && std::isfinite(one.run.transient().state().shortest_contact());
    (touches ? in_contact : others).push_back(moment++);
    return false;
  });
  one.run.run();
  EXPECT_TRUE(in_contact.size() >= 5 || !given.pounds);
  std::mt19937 random{20};
  std::ranges::sample(in_contact, std::back_inserter(chosen), 5, random);
  std::ranges::sample(others, std::back_inserter(chosen), 20 - std::ssize(chosen), random);
  return chosen;
}

void expect_restarts(const Restarted& given) {
  const std::vector<int> moments = moments_of(given);
  Run undisturbed{given};
  undisturbed.run.run();
  const std::string expected = undisturbed.results();
  // A run that is saved on its way is not changed by that.
  std::vector<std::string> saved;
  Run saving{given};
  int moment = 0;
  saving.run.stop_when([&] {
    if (std::ranges::find(moments, moment++) == moments.end()) return false;
    StateArchive archive;
    saving.run.archive(archive);
    saved.push_back(archive.take());
    return false;
  });
  saving.run.run();
  EXPECT_TRUE(saving.results() == expected) << "saving changes the results";
  EXPECT_EQ(saved.size(), 20U);
  for (const std::string& state : saved) {
    Run later{given};
    later.run.go_on_from(StateArchive{state});
    later.run.run();
    EXPECT_TRUE(later.results() == expected) << "saved in " << state.size() << " B";
  }
}

TEST(Restart, OfARunOnALine) { expect_restarts(on_line({})); }
TEST(Restart, OfCompanionAndRunsWithChangedContacts) { expect_restarts(with_error_bars()); }
TEST(Restart, OfExactSteps) {
  expect_restarts(on_line({.integrator = ExactBetweenEvents{}}));
  expect_restarts(on_line({.integrator = Automatic{}}));
}
TEST(Restart, OfFixedStepsAndEventsAtTheirEnds) {
  expect_restarts(on_line({.step = 2 * ms, .events = EventTreatment::at_end_of_step}));
}
TEST(Restart, OfAveragedEquations) {
  expect_restarts(on_line({.integrator = HilberHughesTaylor{}, .step = 2 * ms}));
  expect_restarts(on_line({.integrator = GeneralizedAlpha{.spectral_radius = 0.8}, .step = 2 * ms}));
}
TEST(Restart, OfFilteredCorrections) { expect_restarts(with_strong_dashpot()); }
TEST(Restart, OfLawsWithMemory) {
  expect_restarts(on(BoucWen::typical(), 4));
  expect_restarts(on(TriplePendulum::typical(), 4));
  expect_restarts(on(HeatedLeadRubber::typical(), 4));
  expect_restarts(on(KikuchiAikenRubber::typical(), 4));
}
TEST(Restart, UnderChangingWeight) { expect_restarts(on_changing_weight()); }
TEST(Restart, InPlan) { expect_restarts(in_plan()); }
TEST(Restart, OfAFrame) { expect_restarts(of_frame()); }

// The state of a run after its first step.
std::string state_of(const Restarted& given) {
  Run one{given};
  StateArchive archive;
  int steps = 0;
  one.run.stop_when([&] {
    if (steps++ == 1) one.run.archive(archive);
    return steps == 2;
  });
  one.run.run();
  return archive.take();
}

std::string refusal(const Restarted& given, const std::string& state) {
  Run other{given};
  other.run.go_on_from(StateArchive{state});
  return testing::message_of<InputError>([&] { other.run.run(); });
}

TEST(Restart, RefusesTheStateOfAnotherModelMotionOrMethod) {
  const Restarted own = on_line({});
  const std::string state = state_of(own);
  Restarted wider = own, stronger = own, finer = own;
  wider.model = in_moat(lead_rubber(2 * MN));
  stronger.motion = pulse().scaled_by(-1.0);
  finer.options.transient.tolerance = 1e-5;
  for (const Restarted& each : {wider, stronger, finer, on_line({.integrator = ExactBetweenEvents{}})})
    EXPECT_EQ(refusal(each, state), "The saved state is that of another model, motion or method.");
  EXPECT_EQ(refusal(of_frame(0.03), state_of(of_frame())),
            "The saved state is that of another model, motion or method.");
}

TEST(Restart, RefusesAStateThatIsTooShortOrTooLong) {
  const Restarted given = on_line({});
  const std::string state = state_of(given);
  EXPECT_EQ(refusal(given, state.substr(0, state.size() - 1)),
            "The saved state is shorter than that of this analysis.");
  EXPECT_EQ(refusal(given, state + " "), "The saved state is longer than that of this analysis.");
}

TEST(Restart, NeedsObserversThatCanBeSaved) {
  struct Idle final : StepObserver {
    void start(const StepView&) override {}
    void step(const StepView&) override {}
  } idle;
  const Restarted given = on_line({});
  Transient transient{given.model, given.motion};
  transient.attach(idle);
  transient.advance();
  StateArchive archive;
  EXPECT_EQ(testing::message_of<InputError>([&] { transient.archive(archive); }),
            "An observer of this script has no archive(StateArchive&), which writes and reads its values.");
}

}  // namespace
}  // namespace moat
