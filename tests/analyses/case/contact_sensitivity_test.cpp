// How peaks move when contacts change: the first tour against runs with another program, contacts that appear and
// vanish, and cases without runs.

#include "analyses/case/contact_sensitivity.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "analysis_testing.hpp"
#include "free_slabs.hpp"
#include "in_folder.hpp"
#include "moat.hpp"
#include "output/files/summary.hpp"
#include "peak_in.hpp"
#include "small_models.hpp"

namespace moat {
namespace {

using namespace units;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
const CaseOptions wanted{.error_bars = ErrorBarMode::never, .contact_sensitivity = ContactSensitivityMode::always};

// --- The building of the first tour

GroundMotion pulse() { return near_fault_pulse({.pulse_period = 1.3 * s}).scaled_to_pga(0.4 * g); }

template <class Law>
Model first_tour(const Law& law, Length clearance, const std::optional<FlexibleWall>& wall = {}) {
  Model model;
  const auto building =
      add(model, ShearBuilding{.storeys = 5,
                               .floor_mass = 500 * tonne,
                               .storey_stiffness = 1 * GN / m,
                               .damping = RayleighDamping{.ratio = 0.05},
                               .base_mass = 550 * tonne,
                               .isolation = LeadRubberBearing{.yield_force = 1.93 * MN,
                                                              .yield_displacement = 1 * cm,
                                                              .post_yield_stiffness = 19.3 * MN / m}});
  add(model, Moat{.around = building.base, .clearance = clearance, .law = law, .wall = wall});
  return model;
}

const HertzDamp law_of_paper{.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65};
const ExactHertzDamp usual_law{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65};

// Largest displacements of base and floor 5, m, their accelerations, m/s^2, the impact force, MN, and the touches; by a
// program that shares no code with moat: Runge-Kutta steps of 2.5 to 20 us.
struct ByHand {
  double base, top, base_acceleration, top_acceleration, force;
  std::size_t touches;
};

double changed(const ContactSensitivity& sensitivity, const std::string& quantity, const std::string& where,
               std::size_t change) {
  for (const ChangedPeak& peak : sensitivity.peaks)
    if (peak.quantity == quantity && peak.where == where) return std::abs(peak.changed.at(change));
  ADD_FAILURE() << "no " << quantity << " at " << where;
  return unknown;
}

void expect_rows(const ContactSensitivity& sensitivity, const std::array<ByHand, 6>& rows) {
  constexpr double tolerance = 1e-3;
  ASSERT_TRUE(sensitivity.computed) << sensitivity.reason;
  ASSERT_GE(sensitivity.changes.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SCOPED_TRACE(label_of(sensitivity.changes[i]));
    const ByHand& row = rows[i];
    EXPECT_NEAR(changed(sensitivity, "displacement", "base", i), row.base, tolerance * row.base);
    EXPECT_NEAR(changed(sensitivity, "displacement", "floor 5", i), row.top, tolerance * row.top);
    EXPECT_NEAR(changed(sensitivity, "absolute_acceleration", "base", i), row.base_acceleration,
                tolerance * row.base_acceleration);
    EXPECT_NEAR(changed(sensitivity, "absolute_acceleration", "floor 5", i), row.top_acceleration,
                tolerance * row.top_acceleration);
    EXPECT_NEAR(changed(sensitivity, "impact_force", "moat", i), 1e6 * row.force, tolerance * 1e6 * row.force);
    EXPECT_EQ(sensitivity.changes[i].impacts, row.touches);
  }
}

TEST(ContactSensitivity, OfTheFirstTourWithTheLawOfThePaper) {
  const CaseResult result = run_case(first_tour(law_of_paper, 10 * cm), pulse(), wanted);
  expect_rows(result.contact_sensitivity, {{{0.214027, 0.391907, 32.0851, 42.3230, 38.0816, 8},
                                            {0.134687, 0.297276, 88.3753, 55.8695, 59.8790, 6},
                                            {0.159473, 0.334406, 54.5024, 52.7311, 44.3822, 7},
                                            {0.162301, 0.339023, 53.5829, 54.0467, 46.6242, 7},
                                            {0.149425, 0.318913, 50.0622, 50.6980, 43.7410, 7},
                                            {0.171444, 0.352384, 57.2763, 55.2881, 46.2196, 7}}});
  const ContactSensitivity& sensitivity = result.contact_sensitivity;
  EXPECT_EQ(sensitivity.impacts, 7u);
  EXPECT_TRUE(sensitivity.rigid_walls);
  EXPECT_EQ(sensitivity.changes.size(), 6u);
  ASSERT_EQ(sensitivity.changes[0].contact.size(), 1u);
  EXPECT_EQ(sensitivity.changes[0].contact[0], std::pair(std::string{"moat"}, std::string{"more"}));
  EXPECT_EQ(sensitivity.changes[1].contact[0].second, "fewer");
  EXPECT_EQ(sensitivity.changes[2].contact[0].second, "same");
  EXPECT_NEAR(sensitivity.changes[2].restitutions.at(0), 0.55, 1e-15);
  ASSERT_LE(sensitivity.peaks.size(), result.peaks.size());
  for (std::size_t i = 0; i < sensitivity.peaks.size(); ++i)
    EXPECT_EQ(sensitivity.peaks[i].value, result.peaks[i].value) << sensitivity.peaks[i].quantity;
}

TEST(ContactSensitivity, OfTheFirstTourWithStifferWalls) {
  const CaseResult result = run_case(first_tour(usual_law, 10 * cm), pulse(), wanted);
  expect_rows(result.contact_sensitivity, {{{0.152613, 0.323216, 59.1430, 51.9572, 43.7893, 7},
                                            {0.118378, 0.276115, 145.376, 51.5060, 85.4621, 5},
                                            {0.128515, 0.292079, 96.4441, 52.5110, 59.8935, 6},
                                            {0.132267, 0.294400, 93.0942, 55.3871, 61.4986, 6},
                                            {0.119151, 0.278689, 86.0562, 50.5092, 56.3944, 6},
                                            {0.141351, 0.307224, 100.307, 56.7332, 62.8237, 6}}});
}

TEST(ContactSensitivity, OfTheFirstTourWithAWallThatGivesWay) {
  const HyperbolicBackfill soil{.initial_stiffness = 483.3333333 * MN / m, .ultimate_force = 9.240362812 * MN};
  FlexibleWall wall{.mass = 11785.71429 * kg,
                    .stiffness = 0.4 * 2.34375e9 * N / m,
                    .yield_force = 4 * MN,
                    .hardening_ratio = 0.02,
                    .backfill = soil};
  const CaseResult result = run_case(first_tour(usual_law, 10 * cm, wall), pulse(), wanted);
  // By the same other program.
  EXPECT_NEAR(testing::peak(result, "displacement", "base") / 0.3025730, 1.0, 1e-4);
  EXPECT_NEAR(testing::peak(result, "absolute_acceleration", "base") / 19.4104, 1.0, 1e-4);
  EXPECT_NEAR(testing::peak(result, "impact_force", "moat") / 18.7932e6, 1.0, 1e-4);
  const ContactSensitivity& sensitivity = result.contact_sensitivity;
  expect_rows(sensitivity, {{{0.310731, 0.364380, 17.8980, 20.1817, 18.5870, 3},
                             {0.297318, 0.347994, 20.8752, 21.5337, 18.8585, 3},
                             {0.302043, 0.353786, 19.2912, 21.0791, 18.7796, 3},
                             {0.302978, 0.354934, 19.5820, 21.1723, 18.8035, 3},
                             {0.295437, 0.346497, 19.0159, 20.9706, 18.8633, 3},
                             {0.308550, 0.361494, 19.2978, 20.9731, 18.6938, 3}}});
  EXPECT_FALSE(sensitivity.rigid_walls);
  ASSERT_EQ(sensitivity.changes.size(), 8u);
  EXPECT_EQ(sensitivity.changes[6].parameter, "soil");
  EXPECT_EQ(sensitivity.changes[6].factor, 1.0 / 1.6);
  EXPECT_EQ(sensitivity.changes[7].factor, 1.6);
  wall.backfill->initial_stiffness = 1.6 * soil.initial_stiffness;
  wall.backfill->ultimate_force = 1.6 * soil.ultimate_force;
  const PeaksAndImpacts stiffer = compute_peaks(first_tour(usual_law, 10 * cm, wall), pulse(), {});
  for (std::size_t i = 0; i < sensitivity.peaks.size(); ++i)
    EXPECT_EQ(sensitivity.peaks[i].changed[7], stiffer.peaks[i].value) << sensitivity.peaks[i].quantity;
}

// Without walls the base moves by 0.297534 m, by the other program: 70.2 % of a clearance of 1 m are left.
TEST(ContactSensitivity, MakesNoRunsWhereNothingComesNear) {
  const ContactSensitivity sensitivity = run_case(first_tour(usual_law, 1 * m), pulse(), wanted).contact_sensitivity;
  EXPECT_TRUE(sensitivity.computed);
  EXPECT_TRUE(sensitivity.changes.empty());
  EXPECT_TRUE(sensitivity.peaks.empty());
  EXPECT_EQ(sensitivity.reason,
            "No contact, also with other stiffness and restitution, until the clearance is 70 % smaller.");
  EXPECT_EQ(sensitivity_notes(sensitivity).size(), 1u) << "rigid walls have no part in it";
}

// Bodies that stand wall to wall have no clearance that could be smaller.
TEST(ContactSensitivity, SaysNothingOfTheClearanceWallToWall) {
  Model model;
  const NodeId a = add(model, Node{.name = "a", .mass = 1 * tonne}),
               b = add(model, Node{.name = "b", .mass = 1 * tonne});
  for (const NodeId node : {a, b})
    add(model,
        ShearSpring{
            .name = node == a ? "spring a" : "spring b", .lower = ground, .upper = node, .stiffness = 1 * MN / m});
  add(model,
      Gap{.name = "joint", .left = a, .right = b, .clearance = 0 * m, .law = Hertz{.stiffness = 1e9 * N / m_3_2}});
  // Equal buildings move together.
  const ContactSensitivity sensitivity = run_case(model, pulse(), wanted).contact_sensitivity;
  EXPECT_EQ(sensitivity.reason.find("% smaller"), std::string::npos) << sensitivity.reason;
}

// --- A mass on a spring that swings by 10 cm

constexpr double amplitude = 0.1;  // m

template <class Law>
Model swing(const Law& law, double clearance) {
  const testing::Oscillator given{.velocity = amplitude * 2.0 * std::numbers::pi};
  Model model;
  const NodeId body = testing::add(model, given);
  add(model, Gap<Law>{.name = "wall", .left = body, .right = ground, .clearance = clearance * m, .law = law});
  return model;
}

ContactSensitivity of_swing(double clearance) {
  return run_case(swing(usual_law, clearance), testing::still_ground(1 * s), wanted).contact_sensitivity;
}

TEST(ContactSensitivity, SaysThatAContactVanishes) {
  const ContactSensitivity sensitivity = of_swing(0.95 * amplitude);
  ASSERT_EQ(sensitivity.changes.size(), 6u);
  EXPECT_EQ(sensitivity.changes[5].impacts, 0u);
  ASSERT_EQ(sensitivity.changes[5].contact.size(), 1u);
  EXPECT_EQ(sensitivity.changes[5].contact[0], std::pair(std::string{"wall"}, std::string{"vanishes"}));
  EXPECT_EQ(changed(sensitivity, "impact_force", "wall", 5), 0.0);
  EXPECT_NEAR(changed(sensitivity, "displacement", "body", 5), amplitude, 1e-3 * amplitude);
  for (std::size_t i = 0; i < sensitivity.peaks.size(); ++i)
    if (sensitivity.peaks[i].quantity == "impact_force") {
      EXPECT_FALSE(relative_change(sensitivity.peaks[i], 5).has_value());
    }
}

TEST(ContactSensitivity, RunsASmallerClearanceAloneWhereContactIsNear) {
  const ContactSensitivity sensitivity = of_swing(1.05 * amplitude);
  ASSERT_TRUE(sensitivity.computed) << sensitivity.reason;
  ASSERT_EQ(sensitivity.changes.size(), 1u);
  EXPECT_EQ(sensitivity.changes[0].parameter, "clearance");
  EXPECT_EQ(sensitivity.changes[0].factor, 0.9);
  ASSERT_EQ(sensitivity.changes[0].contact.size(), 1u);
  EXPECT_EQ(sensitivity.changes[0].contact[0].second, "appears");
  EXPECT_GT(changed(sensitivity, "impact_force", "wall", 0), 0.0);
}

TEST(ContactSensitivity, ChangesOnlyParametersThatTheModelHas) {
  const LinearElastic elastic{.stiffness = 1e8 * N / m};
  const auto parameters = [](const Model& model) {
    std::string list;
    for (const ContactVariation& each :
         run_case(model, testing::still_ground(1 * s), wanted).contact_sensitivity.changes)
      list += label_of(each) + " ";
    return list;
  };
  EXPECT_EQ(parameters(swing(elastic, 0.05)), "k/3 3k gap-10% gap+10% ");
  EXPECT_EQ(parameters(swing(usual_law, 0.0)), "k/3 3k e-.1 e+.1 ") << "wall to wall";
  const ContactSensitivity none =
      run_case(testing::oscillator({.velocity = 1.0}), testing::still_ground(1 * s), wanted).contact_sensitivity;
  EXPECT_FALSE(none.computed);
  EXPECT_EQ(none.reason, "");
}

struct LawWithoutParameters {
  static constexpr std::string_view name = "LawWithoutParameters";
  void check(const Check&) const {}
  [[nodiscard]] ViscousHertzContact between(double) const { return {1e9, 0.0}; }
};

TEST(ContactSensitivity, NamesALawThatItCannotChange) {
  const ContactSensitivity sensitivity =
      run_case(swing(LawWithoutParameters{}, 0.05), testing::still_ground(1 * s), wanted).contact_sensitivity;
  EXPECT_EQ(sensitivity.unchanged_laws, std::vector<std::string>{"LawWithoutParameters"});
  EXPECT_EQ(sensitivity.changes.size(), 2u) << "the clearance can be changed";
  EXPECT_NE(
      sensitivity_table(sensitivity, 0.0).find("The law LawWithoutParameters has no parameter that moat can change"),
      std::string::npos);
}

struct StrictLaw {
  Required<HertzStiffness> stiffness;
  double restitution = 0.5;
  void check(const Check& check) const { check.between("restitution", restitution, 0.45, 1.0, "1"); }
  [[nodiscard]] ViscousHertzContact between(double) const { return {stiffness.si(), 0.0}; }
};

TEST(ContactSensitivity, GoesOnWhereALawRefusesAChange) {
  const Model model = swing(StrictLaw{.stiffness = 1e9 * N / m_3_2}, 0.05);
  const ContactSensitivity sensitivity = run_case(model, testing::still_ground(1 * s), wanted).contact_sensitivity;
  ASSERT_EQ(sensitivity.changes.size(), 6u);
  EXPECT_NE(sensitivity.changes[2].failure.find("restitution = 0.4 is not allowed"), std::string::npos)
      << sensitivity.changes[2].failure;
  EXPECT_TRUE(std::isnan(changed(sensitivity, "displacement", "body", 2)));
  EXPECT_TRUE(sensitivity.changes[3].failure.empty());
  EXPECT_GT(changed(sensitivity, "displacement", "body", 3), 0.0);
}

// --- When it is computed

TEST(ContactSensitivity, IsAutomaticByTheCountOfStepsAndElements) {
  const auto automatic = [](Time end) {
    CaseOptions options = wanted;
    options.contact_sensitivity = ContactSensitivityMode::automatic;
    options.transient = {.step = 0.1 * ms, .end = end};
    return run_case(swing(usual_law, 0.05), testing::still_ground(1 * s), options).contact_sensitivity;
  };
  // Two elements and six runs: up to 166 666 steps.
  EXPECT_TRUE(automatic(1 * s).computed);
  const ContactSensitivity long_run = automatic(20 * s);
  EXPECT_FALSE(long_run.computed);
  EXPECT_EQ(long_run.runs_left_out, 6u);
  EXPECT_TRUE(long_run.changes.empty());
  EXPECT_NE(long_run.reason.find("--sensitivity"), std::string::npos) << long_run.reason;
  EXPECT_EQ(sensitivity_table(long_run, 2.0),
            "\nSensitivity to contact parameters: not computed, at most 12 s; --sensitivity\n");
}

TEST(ContactSensitivity, IsNotComputedByDefaultForAModelOfTheSizeOfABenchmark) {
  // 92 bearings, 8 storeys and 20 corners over 60 s in steps of 2 ms.
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne});
  for (int i = 0; i < 120; ++i)
    add(model,
        ShearSpring{.name = "spring " + std::to_string(i), .lower = ground, .upper = body, .stiffness = 1 * MN / m});
  EXPECT_FALSE(contact_sensitivity_is_cheap(model, 30'000, 6));
  EXPECT_TRUE(contact_sensitivity_is_cheap(model, 2'000, 6));
}

TEST(ContactSensitivity, IsNotWantedByDefaultInCode) {
  const CaseResult result = run_case(swing(usual_law, 0.05), testing::still_ground(1 * s));
  EXPECT_FALSE(result.contact_sensitivity.computed);
  EXPECT_EQ(result.contact_sensitivity.reason, "It was not wanted.");
  EXPECT_EQ(result.analysis.contact_sensitivity, "never");
}

TEST(ContactSensitivity, DoesNotChangeTheRunItself) {
  const Model model = swing(usual_law, 0.05);
  const CaseResult with = run_case(model, testing::still_ground(1 * s), wanted),
                   without = run_case(model, testing::still_ground(1 * s), {.error_bars = ErrorBarMode::never});
  ASSERT_EQ(with.peaks.size(), without.peaks.size());
  for (std::size_t i = 0; i < with.peaks.size(); ++i) {
    EXPECT_EQ(with.peaks[i].value, without.peaks[i].value);
    EXPECT_EQ(with.peaks[i].time, without.peaks[i].time);
  }
}

TEST(ContactSensitivity, HasTheErrorsOfTheMainRun) {
  CaseOptions options = wanted;
  options.error_bars = ErrorBarMode::always;
  const CaseResult result = run_case(swing(usual_law, 0.05), testing::still_ground(1 * s), options);
  ASSERT_FALSE(result.contact_sensitivity.peaks.empty());
  for (std::size_t i = 0; i < result.contact_sensitivity.peaks.size(); ++i)
    // Bits, because an error that is not known is not equal to itself.
    EXPECT_EQ(std::bit_cast<std::uint64_t>(result.contact_sensitivity.peaks[i].error),
              std::bit_cast<std::uint64_t>(result.peaks[i].error))
        << result.peaks[i].quantity;
}

TEST(ContactSensitivity, IsStoppedWithTheRun) {
  const Model model = swing(usual_law, 0.05);
  const GroundMotion still = testing::still_ground(1 * s);
  CaseRun run{model, still, wanted};
  bool main_is_over = false;
  run.stop_when([&] { return main_is_over; });
  struct Last final : StepObserver {
    explicit Last(bool& over) : over_{over} {}
    void start(const StepView&) override {}
    void step(const StepView&) override {}
    void finish(const StepView&) override { over_ = true; }
    bool& over_;
  } last{main_is_over};
  run.attach(last);
  run.run();
  EXPECT_FALSE(run.stopped());
  for (const ContactVariation& change : run.result().contact_sensitivity.changes)
    EXPECT_EQ(change.failure, "it was stopped.");
}

class EqualRuns : public testing::InFolder {};

TEST_F(EqualRuns, WriteEqualSensitivities) {
  const auto sensitivity = [&] {
    write_summary_json(run_case(swing(usual_law, 0.05), testing::still_ground(1 * s), wanted), folder / "summary.json");
    const std::string text = testing::read_file(folder / "summary.json");
    const std::size_t begin = text.find("\"contact_sensitivity\": {"), end = text.find("\"impact_units\"");
    return begin < end ? text.substr(begin, end - begin) : std::string{};
  };
  const std::string first = sensitivity();
  EXPECT_EQ(first, sensitivity());
  EXPECT_NE(first.find("\"computed\": true"), std::string::npos) << first;
}

// --- A copy without a change

TEST(WithContacts, WithoutAChangeGivesTheSameBitsOfResults) {
  const auto expect_same = [](const Model& model, const GroundMotion& motion) {
    const PeaksAndImpacts nominal = compute_peaks(model, motion, {}),
                          same = compute_peaks(with_contacts(model, {}), motion, {});
    ASSERT_FALSE(nominal.touches.empty());
    ASSERT_EQ(nominal.peaks.size(), same.peaks.size());
    for (std::size_t i = 0; i < nominal.peaks.size(); ++i) {
      EXPECT_EQ(nominal.peaks[i].value, same.peaks[i].value) << nominal.peaks[i].quantity;
      EXPECT_EQ(nominal.peaks[i].time, same.peaks[i].time) << nominal.peaks[i].quantity;
    }
    EXPECT_EQ(nominal.touches.size(), same.touches.size());
  };
  expect_same(first_tour(law_of_paper, 10 * cm), pulse());
  Model plan;
  const DiaphragmId slab = testing::add_slab(plan, "slab", rectangle(20 * m, 12 * m), 0.5 * m / s, 0.2 * m / s);
  add(plan, PlanMoat{.around = slab, .clearance = 1 * cm, .law = usual_law, .friction = 0.3});
  expect_same(plan, testing::still_ground(0.5 * s));
}

}  // namespace
}  // namespace moat
