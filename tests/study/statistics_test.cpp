#include "study/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "base/error.hpp"
#include "study/floor_spectra_of_records.hpp"
#include "study/profiles.hpp"

namespace moat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

StudyAxis records(std::size_t count) {
  std::vector<std::string> names, hashes;
  for (std::size_t i = 0; i < count; ++i) {
    names.push_back("record " + std::to_string(i));
    hashes.push_back("file " + std::to_string(i));
  }
  StudyAxis axis = StudyAxis::of_names("record", names);
  axis.hashes = hashes;
  return axis;
}

StudyResult study_of(const StudyCases& cases, const std::function<StudyRecord(const StudyCase&)>& compute) {
  std::vector<CaseOutcome> outcomes;
  for (std::size_t i = 0; i < cases.count(); ++i) {
    StudyRecord results = compute(StudyCase{cases, i});
    const CaseState state = results.empty() ? CaseState::not_converged : CaseState::done;
    outcomes.push_back({.state = state, .reason = {}, .results = std::move(results), .files = {}});
  }
  return {cases, outcomes};
}

const RecordStatistics& row(const std::vector<RecordStatistics>& list, const std::string& quantity,
                            const std::string& group, bool envelope = false) {
  const auto found = std::ranges::find_if(list, [&](const RecordStatistics& each) {
    return each.quantity == quantity && each.envelope == envelope && (envelope || each.group == group);
  });
  if (found == list.end()) throw InputError{"no row " + quantity + ", " + group};
  return *found;
}

// The values by hand: mean 2.27/7; median the fourth; 84 % at the place 5.04: 0.41 + 0.04 (0.52 - 0.41).
TEST(Statistics, OfSevenValues) {
  const std::vector<double> values{0.33, 0.21, 0.52, 0.24, 0.41, 0.26, 0.30};
  const Statistics of = statistics_of(values);
  EXPECT_NEAR(of.mean, 2.27 / 7.0, 1e-15);
  EXPECT_EQ(of.median, 0.30);
  EXPECT_NEAR(of.fractile_84, 0.4144, 1e-15);
  EXPECT_EQ(of.largest, 0.52);
  EXPECT_EQ(of.at_largest, 2U);
  double mean = 0.0, squares = 0.0;
  for (const double each : values) mean += std::log(each) / 7.0;
  for (const double each : values) squares += std::pow(std::log(each) - mean, 2);
  EXPECT_NEAR(of.lognormal_median, std::exp(mean), 1e-15);
  EXPECT_NEAR(of.lognormal_median, 0.31023405, 5e-9);
  EXPECT_NEAR(of.dispersion, std::sqrt(squares / 6.0), 1e-15);
  EXPECT_NEAR(of.dispersion, 0.31591776, 5e-9);
  EXPECT_NEAR(of.lognormal_84, 0.42549142, 5e-9);
}

TEST(Statistics, CountACollapseAsInfinite) {
  const Statistics of = statistics_of(std::vector{0.2, infinity, 0.1, 0.3, 0.4});
  EXPECT_EQ(of.mean, infinity);
  EXPECT_EQ(of.median, 0.3);
  EXPECT_EQ(of.fractile_84, infinity);
  EXPECT_TRUE(std::isnan(of.lognormal_median));
  EXPECT_TRUE(std::isnan(statistics_of({}).mean));
}

TEST(StatisticsOverRecords, AreOfEveryGroupAndTheirEnvelope) {
  const StudyAxis bounds = StudyAxis::of_names("bounds", {"lower", "upper"});
  const StudyResult study = study_of({records(7), bounds}, [](const StudyCase& each) {
    const double record = each.value("record");
    const bool upper = each.value("bounds") > 0.0;
    return StudyRecord{{"displacement", "base", "m", upper ? 0.2 : 0.1 * (1.0 + record)},
                       {"displacement_error", "base", "m", 1.0},
                       {"clearance_left", "moat", "m", 0.1 * record - (upper ? 0.2 : 0.0)},
                       {"collapsed", "", "1", 0.0}};
  });
  const std::vector<RecordStatistics> list = statistics_over(study);
  ASSERT_EQ(list.size(), 6U) << "two quantities, two groups and an envelope";
  const RecordStatistics& lower = row(list, "displacement", "bounds = lower");
  EXPECT_NEAR(lower.statistics.mean, 0.4, 1e-15);
  EXPECT_EQ(lower.record, "record 6");
  EXPECT_EQ(lower.solved, 7U);
  EXPECT_EQ(lower.design, lower.statistics.mean);
  const RecordStatistics& envelope = row(list, "displacement", "", true);
  EXPECT_EQ(envelope.group, "bounds = lower") << "with the largest design value";
  EXPECT_EQ(envelope.statistics.largest, lower.statistics.largest);
  // The smallest clearance decides, and the fractile is that from below: -0.2 + 0.1 * 0.96.
  const RecordStatistics& left = row(list, "clearance_left", "bounds = upper");
  EXPECT_NEAR(left.statistics.largest, -0.2, 1e-15);
  EXPECT_NEAR(left.statistics.fractile_84, -0.2 + 0.1 * 0.96, 1e-15);
  EXPECT_EQ(left.record, "record 0");
  EXPECT_EQ(row(list, "clearance_left", "", true).group, "bounds = upper");
  EXPECT_THROW(statistics_over(study, "site"), InputError);
}

TEST(StatisticsOverRecords, DoNotCountCasesWithoutResult) {
  const StudyResult study = study_of({records(4)}, [](const StudyCase& each) {
    if (each.number() == 3) return StudyRecord{};
    return StudyRecord{{"drift", "storey 1", "m", 0.01 * (1.0 + each.value("record"))},
                       {"impact_force", "moat", "N", 5.0},
                       {"clearance_left", "moat", "m", 0.1},
                       {"impacts", "", "1", each.number() == 0 ? 2.0 : 0.0},
                       {"collapsed", "", "1", each.number() == 1 ? 1.0 : 0.0}};
  });
  const std::vector<RecordStatistics> list = statistics_over(study);
  const RecordStatistics& drift = row(list, "drift", "");
  EXPECT_EQ(drift.solved, 3U);
  EXPECT_EQ(drift.unsolved, 1U);
  EXPECT_EQ(drift.collapsed, 1U);
  EXPECT_EQ(drift.statistics.median, 0.03);
  EXPECT_EQ(drift.design, infinity) << "of fewer than seven records the largest";
  EXPECT_EQ(row(list, "impact_force", "").statistics.mean, 5.0) << "results at gaps stay";
  const std::string section = statistics_section(study, list);
  EXPECT_NE(section.find("1 of 4 records touch"), std::string::npos);
  EXPECT_NE(section.find("1 collapsed"), std::string::npos);
  EXPECT_NE(section.find("1 have no result"), std::string::npos);
  EXPECT_NE(section.find("the mean needs seven records"), std::string::npos);
  EXPECT_EQ(table_of(list).rows(), list.size());
}

TEST(StatisticsOverRecords, NeedAnAxisOfRecords) {
  const StudyAxis gap{.name = "gap", .unit = "cm", .values = {10.0, 20.0}};
  const StudyResult study = study_of({gap}, [](const StudyCase&) {
    return StudyRecord{{"drift", "storey 1", "m", 0.01}};
  });
  EXPECT_EQ(axis_of_records(study), "");
  EXPECT_EQ(statistics_section(study, statistics_over(study, "gap")), "");
  EXPECT_EQ(statistics_over(study, "gap").size(), 1U) << "any axis may be chosen";
}

// Seven records of lower properties have 0.1 to 0.7 and the mean 0.4. The last one of upper properties did not
// converge: the largest of six, 0.5, is their design value, although their mean is 0.1.
TEST(StatisticsOverRecords, TheEnvelopeHasTheLargestDesignValue) {
  const StudyAxis bounds = StudyAxis::of_names("bounds", {"lower", "upper"});
  const StudyResult study = study_of({records(7), bounds}, [](const StudyCase& each) {
    const double record = each.value("record");
    const bool upper = each.value("bounds") > 0.0;
    if (upper && record == 6.0) return StudyRecord{};
    return StudyRecord{{"displacement", "base", "m", upper ? (record == 2.0 ? 0.5 : 0.02) : 0.1 * (1.0 + record)}};
  });
  const std::vector<RecordStatistics> list = statistics_over(study);
  EXPECT_NEAR(row(list, "displacement", "bounds = lower").design, 0.4, 1e-15) << "the mean";
  EXPECT_EQ(row(list, "displacement", "bounds = upper").design, 0.5) << "the largest";
  const RecordStatistics& envelope = row(list, "displacement", "", true);
  EXPECT_EQ(envelope.design, 0.5);
  EXPECT_EQ(envelope.group, "bounds = upper");
  EXPECT_NEAR(envelope.statistics.mean, 0.4, 1e-15);
  EXPECT_NEAR(envelope.statistics.largest, 0.7, 1e-15);
  EXPECT_EQ(envelope.record, "record 6") << "with the largest value";
  EXPECT_EQ(envelope.solved, 6U) << "the fewest";
  EXPECT_EQ(envelope.unsolved, 1U);
  const Table table = table_of(list);
  EXPECT_EQ(table.values("design_value"), (std::vector{list[0].design, 0.5, 0.5}));
  EXPECT_NE(statistics_section(study, list).find("the mean of at least seven records, of fewer the largest"),
            std::string::npos);
}

// A clearance left may change its sign: it has no lognormal statistics.
TEST(StatisticsOverRecords, OfClearancesAreNotLognormal) {
  const StudyResult study = study_of({records(7)}, [](const StudyCase& each) {
    return StudyRecord{{"clearance_left", "moat", "m", -0.01 * (1.0 + each.value("record"))}};
  });
  const std::vector<RecordStatistics> list = statistics_over(study);
  const Statistics& of = row(list, "clearance_left", "").statistics;
  EXPECT_NEAR(of.mean, -0.04, 1e-15);
  EXPECT_NEAR(of.largest, -0.07, 1e-15) << "the least clearance";
  for (const double value : {of.lognormal_median, of.lognormal_84, of.dispersion}) EXPECT_TRUE(std::isnan(value));
}

TEST(StatisticsOverRecords, KeepGroupsWithoutAnyResult) {
  const StudyAxis bounds = StudyAxis::of_names("bounds", {"lower", "nominal", "upper"});
  const StudyResult study = study_of({records(2), bounds}, [](const StudyCase& each) {
    const double bound = each.value("bounds");
    if (bound == 2.0) return StudyRecord{};
    StudyRecord results{{"displacement", "base", "m", 0.1}};
    if (bound == 0.0) results.push_back({"drift_ratio", "storey 1", "%", 0.5 + each.value("record")});
    return results;
  });
  const std::vector<RecordStatistics> list = statistics_over(study);
  const RecordStatistics& upper = row(list, "displacement", "bounds = upper");
  EXPECT_EQ(upper.solved, 0U);
  EXPECT_EQ(upper.unsolved, 2U);
  EXPECT_TRUE(std::isnan(upper.design) && std::isnan(upper.statistics.mean));
  EXPECT_EQ(upper.record, "");
  const RecordStatistics& envelope = row(list, "displacement", "", true);
  EXPECT_EQ(envelope.solved, 0U);
  EXPECT_EQ(envelope.unsolved, 2U);
  EXPECT_EQ(envelope.design, 0.1);
  // The models with nominal properties have no such storey: their cases are solved, and are no row.
  EXPECT_THROW(row(list, "drift_ratio", "bounds = nominal"), InputError);
  EXPECT_EQ(row(list, "drift_ratio", "", true).design, 1.5);
  const std::string section = statistics_section(study, list);
  EXPECT_NE(section.find("bounds = upper has no result at all"), std::string::npos) << section;
  EXPECT_NE(section.find("2 have no result"), std::string::npos) << section;
}

TEST(StatisticsOverRecords, ShowAQuantityOfOneGroupToo) {
  const StudyAxis bounds = StudyAxis::of_names("bounds", {"lower", "upper"});
  const StudyResult study = study_of({records(2), bounds}, [](const StudyCase& each) {
    StudyRecord results{{"displacement", "base", "m", 0.1}};
    if (each.value("bounds") > 0.0) results.push_back({"impact_force", "moat", "N", 2e6});
    return results;
  });
  const std::vector<RecordStatistics> list = statistics_over(study);
  EXPECT_EQ(row(list, "impact_force", "", true).group, "bounds = upper");
  EXPECT_NE(statistics_section(study, list).find("<td>Impact force</td>"), std::string::npos)
      << statistics_section(study, list);
}

// A building of one storey, whose base and floor have results.
CaseResult house() {
  CaseResult like;
  like.model.nodes = {{.name = "base"}, {.name = "floor 1", .height = 3.5}};
  like.buildings = {{.name = "house", .base = "base", .floors = {"floor 1"}}};
  return like;
}

StudyRecord house_results(double size, bool collapsed) {
  return {{"absolute_acceleration", "base", "m/s^2", size},
          {"absolute_acceleration", "floor 1", "m/s^2", 2.0 * size},
          {"collapsed", "", "1", collapsed ? 1.0 : 0.0}};
}

TEST(ProfilesOverRecords, HaveACurveForEveryRecordAndTheirMean) {
  const StudyAxis bounds = StudyAxis::of_names("bounds", {"lower", "upper"});
  const StudyResult study = study_of({records(3), bounds}, [](const StudyCase& each) {
    const double scale = (1.0 + each.value("record")) * (each.value("bounds") > 0.0 ? 1.0 : 0.5);
    return StudyRecord{{"absolute_acceleration", "base", "m/s^2", scale},
                       {"absolute_acceleration", "floor 1", "m/s^2", 2.0 * scale},
                       {"collapsed", "", "1", 0.0}};
  });
  const std::vector<Chart> charts = profiles_over_records(study, house());
  ASSERT_EQ(charts.size(), 1U);
  EXPECT_EQ(charts[0].title, "Absolute acceleration over height, house, bounds = upper");
  ASSERT_EQ(charts[0].series.size(), 5U);
  EXPECT_EQ(charts[0].series[3].name, "mean of 3 records");
  EXPECT_EQ(charts[0].series[3].x, (std::vector{2.0, 4.0}));
  EXPECT_EQ(charts[0].series[3].y, (std::vector{0.0, 3.5}));
  EXPECT_NEAR(charts[0].series[4].x[1], 2.0 * (2.0 + 0.68), 1e-12);
}

// The survivors of lower properties are smaller, but a record collapsed: lower properties govern, and their mean is
// infinite. In order 2, 3, infinite: the median is 3, and the 84 % between 3 and infinite.
TEST(ProfilesOverRecords, CountACollapseAsInfinite) {
  const StudyAxis bounds = StudyAxis::of_names("bounds", {"lower", "upper"});
  const StudyResult study = study_of({records(3), bounds}, [](const StudyCase& each) {
    const bool upper = each.value("bounds") > 0.0;
    return house_results((1.0 + each.value("record")) * (upper ? 10.0 : 1.0), each.number() == 0);
  });
  const std::vector<Chart> charts = profiles_over_records(study, house());
  ASSERT_EQ(charts.size(), 1U);
  EXPECT_EQ(charts[0].title, "Absolute acceleration over height, house, bounds = lower");
  ASSERT_EQ(charts[0].series.size(), 3U) << "two records and the median";
  EXPECT_EQ(charts[0].series[0].name, "records, 1 of 3 collapsed: mean infinite");
  EXPECT_EQ(charts[0].series[2].name, "median of 3 records");
  EXPECT_EQ(charts[0].series[2].x, (std::vector{3.0, 6.0}));
}

TEST(ProfilesOverRecords, AreDrawnWhereAllRecordsCollapsed) {
  const StudyResult study =
      study_of({records(2)}, [](const StudyCase& each) { return house_results(1.0 + each.value("record"), true); });
  const std::vector<Chart> charts = profiles_over_records(study, house());
  ASSERT_EQ(charts.size(), 1U);
  ASSERT_EQ(charts[0].series.size(), 2U) << "up to their collapse";
  EXPECT_EQ(charts[0].series[0].name, "records, 2 of 2 collapsed: mean infinite");
  EXPECT_NE(svg_text(charts), "");
}

TEST(ProfilesOverRecords, DoNotCountCasesWithoutResult) {
  const StudyResult study = study_of({records(3)}, [](const StudyCase& each) {
    return each.number() == 1 ? StudyRecord{} : house_results(1.0 + each.value("record"), false);
  });
  const std::vector<Chart> charts = profiles_over_records(study, house());
  ASSERT_EQ(charts.size(), 1U);
  EXPECT_EQ(charts[0].series[0].name, "records, 1 without result");
  EXPECT_EQ(charts[0].series[2].name, "mean of 2 records");
  EXPECT_EQ(charts[0].series[2].x, (std::vector{2.0, 4.0}));
}

TEST(FloorSpectraOverRecords, HaveMeanAndFractile) {
  const StudyResult study = study_of({records(3)}, [](const StudyCase& each) {
    const double size = 1.0 + each.value("record");
    return StudyRecord{{"floor_sa", "roof, x, 5 %, 0.1 s", "m/s^2", size},
                       {"floor_sa", "roof, x, 5 %, 0.3 s", "m/s^2", 2.0 * size},
                       {"floor_sa", "roof, y, 5 %, 0.1 s", "m/s^2", 5.0}};
  });
  const std::vector<Chart> charts = floor_spectra_over_records(statistics_over(study));
  ASSERT_EQ(charts.size(), 2U);
  EXPECT_EQ(charts[0].title, "Floor spectrum, roof, x, 5 %");
  EXPECT_EQ(charts[0].series[1].name, "mean");
  EXPECT_EQ(charts[0].series[1].x, (std::vector{0.1, 0.3}));
  EXPECT_EQ(charts[0].series[1].y, (std::vector{2.0, 4.0}));
  EXPECT_NEAR(charts[0].series[2].y[0], 2.68, 1e-12);
  EXPECT_EQ(charts[0].series[0].y, (std::vector{3.0, 6.0}));
}

TEST(FloorSpectraOverRecords, AreATable) {
  const StudyAxis bounds = StudyAxis::of_names("bounds", {"lower", "upper"});
  const StudyResult study = study_of({records(2), bounds}, [](const StudyCase& each) {
    const double size = (1.0 + each.value("record")) * (1.0 + each.value("bounds"));
    return StudyRecord{{"displacement", "base", "m", 0.1},
                       {"floor_sa", "tower, roof, 5 %, 0.1 s", "m/s^2", size},
                       {"floor_sa", "base, corner 2, y, 2 %, 0.025 s", "m/s^2", 10.0 * size}};
  });
  const Table table = floor_spectra_table(statistics_over(study));
  ASSERT_EQ(table.rows(), 6U) << "two groups and their envelope at two places";
  const auto labels = [&](std::size_t column) { return table.columns[column].labels; };
  EXPECT_EQ(labels(0), (std::vector<std::string>{"tower, roof", "tower, roof", "tower, roof", "base", "base", "base"}));
  EXPECT_EQ(labels(1), (std::vector<std::string>{"centre", "centre", "centre", "corner 2", "corner 2", "corner 2"}));
  EXPECT_EQ(labels(2), (std::vector<std::string>{"x", "x", "x", "y", "y", "y"}));
  EXPECT_EQ(labels(3), (std::vector<std::string>{"bounds = lower", "bounds = upper", "envelope", "bounds = lower",
                                                 "bounds = upper", "envelope"}));
  EXPECT_EQ(table.values("damping"), (std::vector{0.05, 0.05, 0.05, 0.02, 0.02, 0.02}));
  EXPECT_EQ(table.values("period"), (std::vector{0.1, 0.1, 0.1, 0.025, 0.025, 0.025}));
  EXPECT_EQ(table.values("mean"), (std::vector{1.5, 3.0, 3.0, 15.0, 30.0, 30.0}));
  EXPECT_EQ(table.values("largest"), (std::vector{2.0, 4.0, 4.0, 20.0, 40.0, 40.0}));
  EXPECT_EQ(table.values("design_value"), table.values("largest")) << "of two records";
  EXPECT_EQ(floor_spectra_table({}).rows(), 0U);
  // A result of this name that a script chose itself has no period in its place.
  const StudyResult other = study_of({records(2)}, [](const StudyCase&) {
    return StudyRecord{{"floor_sa", "roof", "m/s^2", 1.0}};
  });
  EXPECT_EQ(floor_spectra_table(statistics_over(other)).rows(), 1U);
}

}  // namespace
}  // namespace moat
