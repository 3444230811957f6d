// Parameter studies: the cases, their order, and cases that fail.

#include "moat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

const StudyCases two_axes{{.name = "gap", .unit = "cm", .values = {10.0, 20.0, 40.0}},
                          StudyAxis::of_names("record", {"north", "south"})};

StudyRecord sum(const StudyCase& each) { return {{"sum", "", "1", each.value("gap") + 100.0 * each.value("record")}}; }

TEST(Study, ComputesEveryCombinationOnceWithTheLastAxisFastest) {
  std::atomic<int> calls{0};
  const StudyResult result = run_study(two_axes, [&](const StudyCase& each) {
    ++calls;
    return sum(each);
  });
  EXPECT_EQ(calls, 6);
  ASSERT_EQ(result.table().columns.size(), 3u);
  EXPECT_EQ(result.table().columns[0].quantity, "gap");
  EXPECT_EQ(result.table().columns[0].unit, "cm");
  EXPECT_EQ(result.table().columns[0].values, (std::vector{10.0, 10.0, 20.0, 20.0, 40.0, 40.0}));
  EXPECT_EQ(result.table().columns[1].values, (std::vector{0.0, 1.0, 0.0, 1.0, 0.0, 1.0}));
  EXPECT_EQ(result.values("sum", ""), (std::vector{10.0, 110.0, 20.0, 120.0, 40.0, 140.0}));
}

TEST(Study, TakesTheValuesAlongOneAxis) {
  const StudyResult result = run_study(two_axes, sum);
  EXPECT_EQ(result.values("sum", "", {{"record", 1}}), (std::vector{110.0, 120.0, 140.0}));
  EXPECT_EQ(result.values("sum", "", {{"gap", 2}}), (std::vector{40.0, 140.0}));
  EXPECT_EQ(result.values("sum", "", {{"gap", 1}, {"record", 0}}), (std::vector{20.0}));
}

TEST(Study, KeepsTheOrderWhenLaterCasesEndFirst) {
  const StudyResult result =
      run_study({{.name = "place", .unit = "", .values = linearly_spaced(0.0, 15.0, 16)}},
                [](const StudyCase& each) {
                  if (each.number() == 0) std::this_thread::sleep_for(std::chrono::milliseconds{50});
                  return StudyRecord{{"square", "", "1", each.value("place") * each.value("place")}};
                },
                {.threads = 4});
  for (std::size_t i = 0; i < 16; ++i)
    EXPECT_EQ(result.values("square", "")[i], static_cast<double>(i * i)) << "case " << i;
}

TEST(Study, HasNoNumberWhereACaseHasNoSuchResult) {
  const StudyResult result = run_study(two_axes, [](const StudyCase& each) {
    const std::string storey = each.position("record") == 0 ? "storey 2" : "storey 1";
    return StudyRecord{{"drift", storey, "m", 1.0}};
  });
  const std::vector<double> drift = result.values("drift", "storey 2");
  EXPECT_EQ(drift[0], 1.0);
  EXPECT_TRUE(std::isnan(drift[1]));
}

TEST(Study, NamesTheCasesThatFailedAfterComputingAllOthers) {
  const auto compute = [](const StudyCase& each) {
    if (each.number() == 1) throw InputError{"too stiff"};
    if (each.number() == 4) throw 7;
    return sum(each);
  };
  try {
    run_study(two_axes, compute, {.threads = 2});
    FAIL() << "nothing was thrown";
  } catch (const StudyError& error) {
    EXPECT_STREQ(error.what(),
                 "2 of 6 cases failed.\n"
                 "  case 1, gap = 10 cm, record = south: too stiff\n"
                 "  case 4, gap = 40 cm, record = north: an exception that is not a std::exception");
    ASSERT_EQ(error.failures.size(), 2u);
    EXPECT_EQ(error.failures[1].number, 4u);
    const std::vector<double> sums = error.result.values("sum", "");
    EXPECT_TRUE(std::isnan(sums[1]));
    EXPECT_EQ(sums[5], 140.0);
  }
}

TEST(Study, ListsAtMostFiveFailures) {
  const auto fail = [](const StudyCase&) -> StudyRecord { throw InputError{"no"}; };
  const std::string message = message_of<StudyError>([&] { run_study(two_axes, fail); });
  EXPECT_NE(message.find("6 of 6 cases failed."), std::string::npos) << message;
  EXPECT_NE(message.find("\n  ... and 1 more"), std::string::npos) << message;
}

TEST(Study, CountsItsProgressUpToTheEnd) {
  std::vector<std::size_t> reported;
  run_study(two_axes, sum, {.threads = 3, .progress = [&](const StudyProgress& now) {
                              EXPECT_EQ(now.all, 6u);
                              reported.push_back(now.done);
                            }});
  EXPECT_EQ(reported, (std::vector<std::size_t>{1, 2, 3, 4, 5, 6}));
}

TEST(Study, RefusesAxesThatCannotBe) {
  EXPECT_NE(message_of<InputError>([] { run_study({}, sum); }).find("there is no axis"), std::string::npos);
  EXPECT_NE(message_of<InputError>([] {
              run_study({{.name = "gap", .unit = "m", .values = {}}}, sum);
            }).find("StudyAxis \"gap\": there are no values"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([] {
              run_study({{.name = "a", .unit = "", .values = {1.0}}, {.name = "a", .unit = "", .values = {2.0}}}, sum);
            }).find("the name appears twice"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([] {
              run_study({{.name = "gap", .unit = "m", .values = {std::nan("")}}}, sum);
            }).find("StudyAxis \"gap\""),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([] { run_study(two_axes, sum, {.threads = -1}); }).find("threads = -1"),
            std::string::npos);
}

TEST(Study, RefusesNamesThatAppearTwice) {
  const auto refusal = [](const std::vector<StudyAxis>& axes) {
    return message_of<InputError>([&] { (void)StudyCases{axes}; });
  };
  EXPECT_EQ(refusal({StudyAxis::of_names("record", {"north", "south", "north"})}),
            "StudyAxis \"record\": the label \"north\" appears twice. Give every value a label of its own.");
  EXPECT_NE(refusal({StudyAxis::of_names("state", {"a"})}).find("a column of this name"), std::string::npos);
  EXPECT_NE(refusal({{.name = "", .unit = "", .values = {1.0}}}).find("it has no name"), std::string::npos);
  // In a list the cases must differ, not every axis.
  const StudyAxis law = StudyAxis::of_names("law", {"soft", "stiff", "soft"});
  EXPECT_NO_THROW(StudyCases::list({law, StudyAxis::of_names("record", {"north", "north", "south"})}));
  EXPECT_THROW(StudyCases::list({law, StudyAxis::of_names("record", {"north", "north", "north"})}), InputError);
  EXPECT_NO_THROW(StudyCases::list({law, {.name = "mass", .unit = "t", .values = {1.0, 1.0, 1.0}}}));
}

TEST(Study, DoesNotMixUnits) {
  const StudyResult result = run_study(two_axes, [](const StudyCase& each) {
    return StudyRecord{{"drift", "storey 1", each.number() == 3 ? "cm" : "m", 1.0}};
  });
  EXPECT_EQ(
      message_of<InputError>([&] { (void)result.values("drift", "storey 1"); }),
      "The result \"drift\" of \"storey 1\" has the unit m in some cases and cm in others. Give it one unit, or two "
      "names.");
  EXPECT_EQ(result.table().columns.size(), 4u) << "a column for each unit";
}

TEST(RecordAxis, KnowsTheSamplesOfMotionsMadeInTheProgram) {
  const GroundMotion a = near_fault_pulse({.pulse_period = 1 * s}), b = near_fault_pulse({.pulse_period = 2 * s});
  const StudyAxis axis = record_axis("record", std::vector{a, b});
  EXPECT_EQ(axis.hashes, record_axis("record", std::vector{a, b}).hashes);
  EXPECT_NE(axis.hashes[0], axis.hashes[1]);
  EXPECT_NE(axis.hashes[0], record_axis("record", std::vector{a.scaled_by(2.0), b}).hashes[0]);
  const GroundMotion north{"n", 0.1, {0.0, 1.0}, {}, {"/n", "1"}}, east{"e", 0.1, {0.0, 1.0}, {}, {"/e", "2"}},
      east_changed{"e", 0.1, {0.0, 1.0}, {}, {"/e", "3"}};
  EXPECT_NE(record_axis("pair", std::vector{PlanMotion{north, east, {}}}).hashes,
            record_axis("pair", std::vector{PlanMotion{north, east_changed, {}}}).hashes);
  // Scale, and the incidence of a pair, are not in the files.
  EXPECT_NE(record_axis("record", std::vector{north}).hashes,
            record_axis("record", std::vector{north.scaled_by(2.0)}).hashes);
  EXPECT_NE(record_axis("pair", std::vector{PlanMotion{north, east, {}}}).hashes,
            record_axis("pair", std::vector{PlanMotion{north, east.scaled_by(2.0), {}}}).hashes);
  PlanMotion turned{north, east, {}};
  turned.incidence = 30 * deg;
  EXPECT_NE(record_axis("pair", std::vector{PlanMotion{north, east, {}}}).hashes,
            record_axis("pair", std::vector{turned}).hashes);
}

TEST(Study, RefusesNamesItDoesNotKnow) {
  EXPECT_EQ(message_of<InputError>([] {
              (void)StudyCase{two_axes, 0}.value("mass");
            }),
            "The study has no axis \"mass\". Its axes are: gap, record.");
  const StudyResult result = run_study(two_axes, sum);
  EXPECT_EQ(message_of<InputError>([&] { (void)result.values("drift", "storey 1"); }),
            "The study has no result \"drift\" of \"storey 1\".");
  EXPECT_EQ(message_of<InputError>([] { (void)value_of(StudyRecord{}, "drift", "storey 9"); }),
            "There is no result \"drift\" of \"storey 9\". Give quantity and place as the table of results "
            "writes them.");
  // An axis is not a result.
  EXPECT_NE(message_of<InputError>([&] { (void)result.values("gap", ""); }), "nothing was thrown");
}

TEST(Study, SpacesValuesFromEndToEnd) {
  EXPECT_EQ(linearly_spaced(1.0, 2.0, 5), (std::vector{1.0, 1.25, 1.5, 1.75, 2.0}));
  const std::vector<double> decades = logarithmically_spaced(0.01, 10.0, 4);
  EXPECT_EQ(decades.front(), 0.01);
  EXPECT_EQ(decades.back(), 10.0);
  EXPECT_NEAR(decades[1], 0.1, 1e-15);
  EXPECT_NEAR(decades[2], 1.0, 1e-14);
}

/// Two storeys in a moat, hit by a pulse: contact, yielding and repeated steps in every case.
StudyModel pounding_building(const StudyCase& each) {
  StudyModel study{Model{}, near_fault_pulse({.quiet_after = 1 * s}).scaled_to_pga(0.4 * g)};
  const auto building =
      add(study.model,
          ShearBuilding{.storeys = 2,
                        .floor_mass = 500 * tonne,
                        .storey_stiffness = 1 * GN / m,
                        .damping = {.ratio = 0.05},
                        .base_mass = 550 * tonne,
                        .isolation = LeadRubberBearing{
                            .yield_force = 1 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 10 * MN / m}});
  add(study.model, Moat{.around = building.base,
                        .clearance = each.value("gap") * cm,
                        .law = HertzDamp{.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65}});
  return study;
}

const StudyCases gaps{{.name = "gap", .unit = "cm", .values = linearly_spaced(5.0, 20.0, 12)}};

TEST(Study, GivesTheSameBitsOnOneThreadAndOnSeveral) {
  const StudyResult one = run_study(gaps, pounding_building, {.threads = 1});
  const StudyResult several = run_study(gaps, pounding_building, {.threads = 4});
  ASSERT_EQ(one.table().columns.size(), several.table().columns.size());
  EXPECT_GT(one.values("impacts", "")[0], 0.0);
  for (std::size_t i = 0; i < one.table().columns.size(); ++i) {
    EXPECT_EQ(one.table().columns[i].quantity, several.table().columns[i].quantity);
    EXPECT_EQ(one.table().columns[i].values, several.table().columns[i].values) << one.table().columns[i].quantity;
  }
}

TEST(Study, GivesEveryPeakItsErrorIfAsked) {
  const StudyResult without = run_study(gaps, pounding_building);
  const StudyResult with = run_study(gaps, pounding_building, {.error_bars = true});
  EXPECT_EQ(with.values("impact_force", "moat"), without.values("impact_force", "moat"));
  EXPECT_THROW((void)without.values("impact_force_error", "moat"), InputError);
  EXPECT_THROW((void)without.values("unsettled", ""), InputError);
  // The column stands beside its peak, in the same unit.
  const std::vector<Column>& columns = with.table().columns;
  const auto peak = std::ranges::find(columns, "impact_force", &Column::quantity);
  ASSERT_LT(peak + 1, columns.end());
  EXPECT_EQ((peak + 1)->quantity, "impact_force_error");
  EXPECT_EQ((peak + 1)->where, "moat");
  EXPECT_EQ((peak + 1)->unit, "N");
}

TEST(Study, TakesContactParametersAsAxes) {
  const StudyCases softer{{.name = "gap", .unit = "cm", .values = {10.0}},
                          {.name = "contact_stiffness_factor", .unit = "", .values = {1.0, 3.0}},
                          {.name = "restitution_change", .unit = "", .values = {-0.1}},
                          {.name = "clearance_factor", .unit = "", .values = {0.9}}};
  const StudyCase second{softer, 1};
  const ContactChange change = contact_change(second);
  EXPECT_EQ(change.stiffness_factor, 3.0);
  EXPECT_EQ(change.restitution_change, -0.1);
  EXPECT_EQ(change.clearance_factor, 0.9);
  EXPECT_EQ(change.soil_factor, 1.0) << "a parameter without axis stays";
  const StudyResult result = run_study(softer, [](const StudyCase& each) {
    StudyModel study = pounding_building(each);
    study.model = with_contacts(study.model, contact_change(each));
    return study;
  });
  const StudyModel nominal = pounding_building(second);
  const PeaksAndImpacts by_hand = compute_peaks(with_contacts(nominal.model, change), nominal.motion, {});
  for (const Peak& peak : by_hand.peaks)
    EXPECT_EQ(result.values(peak.quantity, peak.where)[1], peak.magnitude()) << peak.quantity << " " << peak.where;
}

TEST(Study, TablesHaveTheNamesOfAnAxis) {
  const StudyResult result = run_study(
      {StudyAxis::of_names("record", {"KJM000", "TAK000"}), {.name = "gap", .unit = "cm", .values = {1.0, 2.0}}},
      std::function<StudyRecord(const StudyCase&)>{sum});
  EXPECT_EQ(result.table().columns[0].labels, (std::vector<std::string>{"KJM000", "KJM000", "TAK000", "TAK000"}));
  EXPECT_EQ(result.table().columns[0].values, (std::vector<double>{0.0, 0.0, 1.0, 1.0}));
  EXPECT_TRUE(result.table().columns[1].labels.empty());
}

TEST(Study, HasThePeaksErrorsClearancesAndImpactsOfASingleRun) {
  const StudyResult all = run_study(gaps, pounding_building);
  for (std::size_t i = 0; i < gaps.count(); ++i) {
    StudyModel study = pounding_building(StudyCase{gaps, i});
    // With histories, a single run would take no longer steps than this by default.
    const TransientOptions options{.largest_step = study.motion.time_step() * s};
    const StudyRecord record = peaks_of(study.model, study.motion, options, true);
    const CaseResult result =
        run_case(study.model, study.motion, {.transient = options, .error_bars = ErrorBarMode::always});
    for (const Peak& peak : result.peaks) {
      EXPECT_EQ(value_of(record, peak.quantity, peak.where), peak.magnitude()) << peak.quantity << " " << peak.where;
      EXPECT_EQ(value_of(record, peak.quantity + "_error", peak.where), peak.error) << peak.quantity << peak.where;
    }
    EXPECT_EQ(value_of(record, "unsettled", ""), result.error_bars.unsettled ? 1.0 : 0.0);
    EXPECT_EQ(value_of(record, "impacts", ""), static_cast<double>(result.impacts.size())) << i;
    ASSERT_EQ(result.clearances.size(), 2u);
    for (const GapClearance& gap : result.clearances) {
      EXPECT_EQ(value_of(record, "clearance_left", gap.where), gap.left) << gap.where;
      EXPECT_EQ(value_of(record, "clearance_left_error", gap.where), gap.error) << gap.where;
      EXPECT_GT(gap.error, 0.0) << gap.where;
      if (i == 3) {
        EXPECT_LT(gap.error, 0.01 * gap.clearance) << gap.where;
      }
    }
    EXPECT_EQ(all.values("impact_force", "moat")[i],
              value_of(peaks_of(study.model, study.motion), "impact_force", "moat"));
  }
}

TEST(Study, HasFloorSpectraIfAsked) {
  const FloorSpectraOptions options{
      .floors = {"floor 2"}, .dampings = {0.02, 0.05}, .periods = {0.05 * s, 0.3 * s}, .absolute_acceleration = true};
  const StudyResult all = run_study(gaps, pounding_building, {.floor_spectra = options});
  EXPECT_THROW((void)run_study(gaps, pounding_building).values("floor_sa", "floor 2, 5 %, 0.3 s"), InputError);
  for (std::size_t i = 0; i < gaps.count(); ++i) {
    const StudyModel study = pounding_building(StudyCase{gaps, i});
    FloorSpectra spectra{options};
    Transient analysis{study.model, study.motion};
    analysis.attach(spectra);
    analysis.run();
    const ResponseSpectrum of_2 = spectra.spectra().at(0).spectrum, of_5 = spectra.spectra().at(1).spectrum;
    EXPECT_EQ(all.values("floor_sa", "floor 2, 2 %, 0.05 s")[i], of_2.pseudo_acceleration[0]);
    EXPECT_EQ(all.values("floor_sa", "floor 2, 5 %, 0.3 s")[i], of_5.pseudo_acceleration[1]);
    EXPECT_EQ(all.values("floor_sa_absolute", "floor 2, 5 %, 0.3 s")[i], of_5.absolute_acceleration[1]);
  }
}

TEST(Study, HasEnergiesThatBalanceIfAsked) {
  const StudyResult without = run_study(gaps, pounding_building);
  const StudyResult with = run_study(gaps, pounding_building, {.energies = true});
  EXPECT_EQ(with.values("impact_force", "moat"), without.values("impact_force", "moat"));
  EXPECT_THROW((void)without.values("energy_input", ""), InputError);
  for (std::size_t i = 0; i < gaps.count(); ++i) {
    EXPECT_TRUE(std::isnan(without.outcome(i).energy_error));
    const double error = with.outcome(i).energy_error;
    EXPECT_GE(error, 0.0);
    EXPECT_LT(error, 1e-3);
    const StudyRecord record = with.outcome(i).results;
    double balance = -value_of(record, "energy_input", "");
    for (const char* part : {"kinetic", "strain", "viscous", "hysteretic", "impact"})
      balance += value_of(record, std::string{"energy_"} + part, "");
    // Both errors together, relative to the largest energy, which may exceed the input at the end.
    EXPECT_LT(std::abs(balance), 4e-3 * value_of(record, "energy_input", "")) << i;
    EXPECT_GT(with.outcome(i).steps, 100);
    EXPECT_EQ(with.outcome(i).steps, without.outcome(i).steps);
  }
}

TEST(Study, EndsWhereItIsAskedTo) {
  std::atomic<int> computed{0};
  const auto compute = [&](const StudyCase& each) {
    ++computed;
    return sum(each);
  };
  try {
    run_study(two_axes, compute, {.threads = 1, .stop = [&] { return computed >= 2; }});
    FAIL() << "nothing was thrown";
  } catch (const StudyStopped& stopped) {
    EXPECT_EQ(computed, 2);
    EXPECT_EQ(stopped.result.count(CaseState::done), 2u);
    EXPECT_EQ(stopped.result.count(CaseState::open), 4u);
    EXPECT_STREQ(stopped.what(), "The study was stopped: 2 of 6 cases are computed.");
  }
}

TEST(Study, ComputesAPartAlone) {
  const StudyResult part = run_study(two_axes, sum, {.part = {{1, 3}}});
  EXPECT_EQ(part.count(CaseState::done), 2u);
  EXPECT_EQ(run_study(two_axes, sum, {.part = {{3, 6}}}).count(CaseState::done), 3u) << "up to the last case";
  EXPECT_EQ(part.values("sum", "")[2], 20.0);
  EXPECT_TRUE(std::isnan(part.values("sum", "")[3]));
  EXPECT_THROW((void)run_study(two_axes, sum, {.part = {{3, 3}}}), InputError);
  EXPECT_THROW((void)run_study(two_axes, sum, {.part = {{3, 7}}}), InputError);
}

TEST(Study, CountsTheCasesThatFailedInItsProgress) {
  std::vector<std::size_t> failed;
  run_study(two_axes,
            [](const StudyCase& each) {
              if (each.number() == 1) throw ConvergenceError{"stuck", 1.0, 0.1, 1.0, "x"};
              if (each.number() == 4) throw InputError{"wrong"};
              return sum(each);
            },
            {.threads = 1,
             .progress = [&](const StudyProgress& now) { failed.push_back(now.failed); },
             .keep_failures = true});
  EXPECT_EQ(failed, (std::vector<std::size_t>{0, 1, 1, 1, 2, 2}));
}

TEST(Study, KnowsCasesThatDoNotConverge) {
  const StudyResult result = run_study(two_axes,
                                       [](const StudyCase& each) {
                                         if (each.number() == 1) throw ConvergenceError{"stuck", 1.0, 0.1, 1.0, "x"};
                                         if (each.number() == 2) throw InputError{"wrong"};
                                         return sum(each);
                                       },
                                       {.keep_failures = true});
  EXPECT_EQ(result.state(1), CaseState::not_converged);
  EXPECT_EQ(result.state(2), CaseState::failed);
  EXPECT_TRUE(
      failure_message(result).starts_with("2 of 6 cases failed, 1 of them did not converge.\n  case 1, gap = "));
}

}  // namespace
}  // namespace moat
