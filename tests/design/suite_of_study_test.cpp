#include "design/suite_of_study.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "message_of.hpp"
#include "motions/near_fault_pulse.hpp"
#include "motions/spectra/code_spectra.hpp"

namespace moat {
namespace {

// The first cases have no result.
StudyResult suite(std::size_t records, std::size_t unsolved = 0) {
  std::vector<std::string> names, hashes;
  for (std::size_t i = 0; i < records; ++i) {
    names.push_back("record " + std::to_string(i));
    hashes.push_back(names.back());
  }
  StudyAxis axis = StudyAxis::of_names("record", names);
  axis.hashes = hashes;
  const StudyCases cases{axis, StudyAxis::of_names("bounds", {"lower", "nominal", "upper"}),
                         StudyAxis::of_names("eccentricity", {"none", "+x"})};
  std::vector<CaseOutcome> outcomes;
  for (std::size_t i = 0; i < cases.count(); ++i) {
    if (i < unsolved) {
      outcomes.push_back({.state = CaseState::not_converged, .reason = {}, .results = {}, .files = {}});
      continue;
    }
    const StudyCase each{cases, i};
    const double size = 0.1 * (1.0 + each.value("record")), bound = 1.0 + each.value("bounds"),
                 eccentric = 1.0 + 0.5 * each.value("eccentricity");
    outcomes.push_back({.state = CaseState::done,
                        .reason = {},
                        .results = {{"displacement", "base", "m", size / bound},
                                    {"corner_displacement", "base", "m", eccentric * size / bound},
                                    {"displacement", "roof", "m", 9.0},
                                    {"total_base_shear_x", "base", "N", 1.2e6 * bound},
                                    {"total_base_shear_y", "base", "N", 1e6 * bound},
                                    {"storey_shear_x", "storey 1", "N", 2e6 * bound},
                                    {"storey_shear_y", "storey 1", "N", 3e6 * bound},
                                    // Impacts between floors may make a higher storey govern.
                                    {"storey_shear_x", "storey 2", "N", 9e6},
                                    {"storey_shear_y", "storey 2", "N", 9e6},
                                    {"corner_drift_ratio", "storey 1", "%", 0.5}},
                        .files = {}});
  }
  return {cases, outcomes};
}

TEST(SuiteForSheet, HasTheDesignValuesOfEveryBound) {
  const SuiteForSheet of = suite_for_sheet(suite(7));
  EXPECT_EQ(of.statistic, "mean of 7 records");
  // The mean of 0.1 to 0.7 m.
  EXPECT_NEAR(of.lower.displacement.si(), 0.4, 1e-15);
  EXPECT_NEAR(of.upper.displacement.si(), 0.4 / 3.0, 1e-15);
  EXPECT_NEAR(of.nominal.corner_displacement.si(), 1.5 * 0.2, 1e-15) << "the largest over the eccentricities";
  EXPECT_NEAR(of.upper.base_shear.si(), 3e6, 1e-9) << "the smaller of x and y";
  EXPECT_NEAR(of.lower.storey_shear.si(), 2e6, 1e-9) << "that of storey 1, the smaller of x and y";
  EXPECT_EQ(of.nominal.touching, 0u);
  EXPECT_TRUE(of.base_shear_has_impacts) << "the study has no force of the isolators alone";
  EXPECT_TRUE(of.scaling.empty());
  EXPECT_NEAR(of.nominal.drift, 0.005, 1e-15);
  EXPECT_EQ(suite_for_sheet(suite(3)).statistic, "largest of 3 records");
  EXPECT_NEAR(suite_for_sheet(suite(3)).lower.displacement.si(), 0.3, 1e-15);
}

// Every case of a suite with more results.
StudyResult with_results(StudyResult study, const std::function<StudyRecord(const StudyCase&)>& more) {
  for (std::size_t i = 0; i < study.cases().count(); ++i) {
    CaseOutcome outcome = study.outcome(i);
    for (const NamedNumber& each : more(StudyCase{study.cases(), i})) outcome.results.push_back(each);
    study.set(i, std::move(outcome));
  }
  return study;
}

TEST(SuiteForSheet, TakesTheIsolatorsAloneAndCountsTheRecordsThatTouch) {
  const SuiteForSheet of = suite_for_sheet(with_results(suite(7), [](const StudyCase& each) -> StudyRecord {
    // Records 5 and 6 touch, with lower bounds and one eccentricity.
    const bool touches =
        each.value("record") > 4.5 && each.label("bounds") == "lower" && each.value("eccentricity") > 0.0;
    return {{"impacts", "", "1", touches ? 3.0 : 0.0},
            {"total_isolator_force_x", "base", "N", 7e5},
            {"total_isolator_force_y", "base", "N", 8e5}};
  }));
  EXPECT_EQ(of.lower.touching, 2u);
  EXPECT_EQ(of.nominal.touching, 0u);
  EXPECT_EQ(of.upper.touching, 0u);
  EXPECT_FALSE(of.base_shear_has_impacts);
  EXPECT_NEAR(of.lower.base_shear.si(), 7e5, 1e-9);
}

// The result of one direction is that in the worst of all eccentricities and directions.
TEST(SuiteForSheet, TakesTheLargestOfEachComponentBeforeTheSmaller) {
  const SuiteForSheet of = suite_for_sheet(with_results(suite(7), [](const StudyCase& each) -> StudyRecord {
    const bool first = each.value("eccentricity") < 0.5;
    return {{"total_isolator_force_x", "base", "N", first ? 9e5 : 2e5},
            {"total_isolator_force_y", "base", "N", first ? 1e5 : 8e5}};
  }));
  EXPECT_NEAR(of.nominal.base_shear.si(), 8e5, 1e-9);
}

TEST(SuiteForSheet, OfALineHasOneDirectionAndTheFirstStoreyOfItsBuilding) {
  StudyAxis records = StudyAxis::of_names("record", {"a", "b"});
  records.hashes = {"a", "b"};
  const StudyCases cases{records};
  const CaseOutcome done{.state = CaseState::done,
                         .reason = {},
                         .results = {{"displacement", "west base", "m", 0.3},
                                     {"total_base_shear", "west base", "N", 1e6},
                                     {"total_base_shear", "east base", "N", 9e6},
                                     {"storey_shear", "west storey 1", "N", 5e5},
                                     {"storey_shear", "east storey 1", "N", 9e6}},
                         .files = {}};
  const SuiteForSheet of = suite_for_sheet(StudyResult{cases, {done, done}}, "west base");
  EXPECT_NEAR(of.nominal.base_shear.si(), 1e6, 1e-9);
  EXPECT_NEAR(of.nominal.storey_shear.si(), 5e5, 1e-9);
}

TEST(SuiteForSheet, FindsTheShearOfABuildingWithoutName) {
  StudyAxis records = StudyAxis::of_names("record", {"a", "b"});
  records.hashes = {"a", "b"};
  const CaseOutcome done{.state = CaseState::done,
                         .reason = {},
                         .results = {{"displacement", "cellar", "m", 0.3}, {"total_base_shear", "base", "N", 1e6}},
                         .files = {}};
  const SuiteForSheet of = suite_for_sheet(StudyResult{StudyCases{records}, {done, done}}, "cellar");
  EXPECT_NEAR(of.nominal.base_shear.si(), 1e6, 1e-9);
}

// A name that another one contains is another one: "lower" and "lower 2", "bounds" and "old bounds".
TEST(SuiteForSheet, KnowsBoundsByTheirAxis) {
  StudyAxis records = StudyAxis::of_names("record", {"a", "b"});
  records.hashes = {"a", "b"};
  const StudyCases cases{records, StudyAxis::of_names("old bounds", {"lower", "nominal", "upper"}),
                         StudyAxis::of_names("bounds", {"lower 2", "lower", "nominal", "upper"})};
  std::vector<CaseOutcome> outcomes;
  for (std::size_t i = 0; i < cases.count(); ++i)
    outcomes.push_back(
        {.state = CaseState::done,
         .reason = {},
         .results = {{"displacement", "base", "m", StudyCase{cases, i}.value("bounds") < 0.5 ? 9.0 : 0.5}},
         .files = {}});
  const SuiteForSheet of = suite_for_sheet(StudyResult{cases, outcomes});
  for (const SuiteValues& each : {of.lower, of.nominal, of.upper}) EXPECT_NEAR(each.displacement.si(), 0.5, 1e-15);
}

TEST(SuiteForSheet, KeepsTheRuleOfScaling) {
  const ScaledSuite scaled = scale_suite(
      {{"one", {near_fault_pulse(), near_fault_pulse()}}},
      Asce7Spectrum{.s_ds = 0.8, .s_d1 = 0.45, .long_period = 8 * units::s}.mce_r(),
      SuiteScaling{.name = "mine", .source = "me", .shortest = 1 * units::s, .longest = 2 * units::s, .fraction = 0.8});
  const SuiteForSheet of = suite_for_sheet(suite(7), scaled);
  EXPECT_EQ(of.scaling, scaled.description());
  EXPECT_EQ(of.scaling[2], "Mean SRSS of 1 records >= 0.8 target from 1 to 2 s, damping 5 %");
}

// A case without result does not count, and the sheet says how many do.
TEST(SuiteForSheet, SaysThatCasesAreMissing) {
  EXPECT_EQ(suite_for_sheet(suite(8, 1)).statistic, "mean of 7 of 8 records");
  const SuiteForSheet six = suite_for_sheet(suite(7, 1));
  EXPECT_EQ(six.statistic, "largest of 6 of 7 records");
  EXPECT_NEAR(six.lower.displacement.si(), 0.7, 1e-15);
}

// The other eccentricity of the bound has results, but they say nothing about this one.
TEST(SuiteForSheet, IsRefusedWhereACombinationHasNoResult) {
  StudyResult study = suite(2);
  for (std::size_t i = 1; i < study.cases().count(); i += 6)
    study.set(i, {.state = CaseState::failed, .reason = "lost"});
  EXPECT_EQ(testing::message_of([&] { suite_for_sheet(study); }),
            "suite_for_sheet: no record has a result with bounds = lower, eccentricity = +x. Compute its cases again.");
}

TEST(SuiteForSheet, IsRefusedWhereARecordCollapsed) {
  const StudyResult study = with_results(suite(7), [](const StudyCase& each) -> StudyRecord {
    return {{"collapsed", "", "1", each.number() == 0 ? 1.0 : 0.0}};
  });
  EXPECT_EQ(
      testing::message_of([&] { suite_for_sheet(study); }),
      "suite_for_sheet: records of lower bounds collapsed, so that there is no design value. Change the design, or "
      "give the sheet without a suite.");
}

TEST(SuiteForSheet, RefusesAnotherBase) {
  const StudyResult study = suite(2);
  EXPECT_EQ(
      testing::message_of([&] { suite_for_sheet(study, "cellar"); }),
      "suite_for_sheet: no case of nominal properties has a displacement of \"cellar\". Give the name of the base, or "
      "compute its cases again.");
}

}  // namespace
}  // namespace moat
