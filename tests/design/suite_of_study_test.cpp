#include "design/suite_of_study.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "message_of.hpp"

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
                                    {"total_base_shear_y", "base", "N", 1e6 * bound},
                                    {"storey_shear_x", "storey 1", "N", 2e6 * bound},
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
  EXPECT_NEAR(of.upper.base_shear.si(), 3e6, 1e-9);
  EXPECT_NEAR(of.lower.storey_shear.si(), 2e6, 1e-9);
  EXPECT_NEAR(of.nominal.drift, 0.005, 1e-15);
  EXPECT_EQ(suite_for_sheet(suite(3)).statistic, "largest of 3 records");
  EXPECT_NEAR(suite_for_sheet(suite(3)).lower.displacement.si(), 0.3, 1e-15);
}

// A case without result does not count, and the sheet says how many do.
TEST(SuiteForSheet, SaysThatCasesAreMissing) {
  EXPECT_EQ(suite_for_sheet(suite(8, 1)).statistic, "mean of 7 of 8 records");
  const SuiteForSheet six = suite_for_sheet(suite(7, 1));
  EXPECT_EQ(six.statistic, "largest of 6 of 7 records");
  EXPECT_NEAR(six.lower.displacement.si(), 0.7, 1e-15);
}

TEST(SuiteForSheet, IsRefusedWhereARecordCollapsed) {
  const StudyResult good = suite(7);
  std::vector<CaseOutcome> outcomes = good.outcomes();
  for (CaseOutcome& each : outcomes) each.results.push_back({"collapsed", "", "1", 0.0});
  outcomes[0].results.back().value = 1.0;
  EXPECT_EQ(
      testing::message_of([&] {
        suite_for_sheet(StudyResult{good.cases(), outcomes});
      }),
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
