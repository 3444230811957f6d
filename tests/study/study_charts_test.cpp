// Pictures of studies.

#include "study/study_charts.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace moat {
namespace {

const StudyAxis gap{.name = "gap", .unit = "cm", .values = {10.0, 20.0, 30.0}};
const StudyAxis force{.name = "force", .unit = "MN", .values = {1.0, 2.0, 3.0, 4.0}};

StudyAxis records(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.push_back("record " + std::to_string(i));
  return StudyAxis::of_names("record", names);
}

StudyResult study_of(const StudyCases& cases, const std::function<StudyRecord(const StudyCase&)>& compute) {
  std::vector<CaseOutcome> outcomes;
  for (std::size_t i = 0; i < cases.count(); ++i)
    outcomes.push_back({.state = CaseState::done, .results = compute(StudyCase{cases, i})});
  return {cases, outcomes};
}

TEST(AxisCharts, HaveACurveForEveryRecord) {
  const StudyResult study = study_of({gap, records(2)}, [](const StudyCase& each) {
    const double drift = 0.01 * each.value("gap") * (1.0 + each.value("record"));
    return StudyRecord{{"drift", "storey 1", "m", drift},
                       {"drift", "storey 2", "m", 0.5 * drift},
                       {"clearance_left", "left", "m", 0.2},
                       {"clearance_left", "right", "m", 0.1},
                       {"drift_error", "storey 1", "m", 1.0}};
  });
  const std::vector<Chart> charts = axis_charts(study);
  ASSERT_EQ(charts.size(), 2u);
  EXPECT_EQ(charts[0].title, "Smallest clearance left") << "pounding comes first";
  EXPECT_EQ(charts[0].series[0].y, (std::vector{10.0, 10.0, 10.0}));
  EXPECT_EQ(charts[1].title, "Largest drift");
  EXPECT_EQ(charts[1].x_label, "gap [cm]");
  EXPECT_EQ(charts[1].y_label, "drift [cm]");
  ASSERT_EQ(charts[1].series.size(), 2u);
  EXPECT_EQ(charts[1].series[1].name, "record 1");
  EXPECT_EQ(charts[1].series[1].y, (std::vector{20.0, 40.0, 60.0}));
  EXPECT_NO_THROW((void)svg_text(charts));
}

TEST(AxisCharts, OfManyRecordsShowTheMedianAndItsBand) {
  const StudyResult study = study_of({gap, records(101)}, [](const StudyCase& each) {
    return StudyRecord{{"impacts", "", "1", each.value("record")}};
  });
  const std::vector<Chart> charts = axis_charts(study);
  ASSERT_EQ(charts.size(), 1u);
  ASSERT_EQ(charts[0].series.size(), 2u);
  EXPECT_EQ(charts[0].series[0].style, Series::Style::band);
  EXPECT_EQ(charts[0].series[0].y, (std::vector{84.0, 84.0, 84.0, 16.0, 16.0, 16.0}));
  EXPECT_EQ(charts[0].series[1].y, (std::vector{50.0, 50.0, 50.0}));
  EXPECT_NE(svg_text(charts).find("<polygon"), std::string::npos);
}

TEST(HeatMaps, AreMediansOverTheOtherAxes) {
  const StudyResult study = study_of({gap, force, records(3)}, [](const StudyCase& each) {
    return StudyRecord{{"impact_force", "moat", "N",
                        1e3 * (each.value("gap") + 100.0 * each.value("force") + std::pow(each.value("record"), 3))}};
  });
  const std::vector<HeatMap> maps = heat_maps(study);
  ASSERT_EQ(maps.size(), 1u);
  EXPECT_EQ(maps[0].value_label, "impact force [kN]");
  EXPECT_EQ(maps[0].x_values, (std::vector<std::string>{"10", "20", "30"}));
  ASSERT_EQ(maps[0].values.size(), 4u);
  EXPECT_NEAR(maps[0].values[1][2], 30.0 + 200.0 + 1.0, 1e-9);
  EXPECT_TRUE(heat_maps(study_of({gap, records(3)}, [](const StudyCase&) { return StudyRecord{}; })).empty());
}

TEST(Charts, CountCollapsedCasesAsInfinite) {
  // Of 101 records 20 fell at 20 cm, 60 at 30 cm; their last drift was 102 m.
  const auto compute = [](const StudyCase& each) {
    const bool fell = each.value("record") < (each.value("gap") > 25.0 ? 60.0 : each.value("gap") > 15.0 ? 20.0 : 0.0);
    return StudyRecord{{"drift", "storey 1", "m", fell ? 102.0 : 0.01 * each.value("record")},
                       {"collapsed", "", "1", fell ? 1.0 : 0.0}};
  };
  const std::vector<Chart> charts = axis_charts(study_of({gap, records(101)}, compute));
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_EQ(charts[0].series[1].x, (std::vector{10.0, 20.0})) << "the median at 30 cm is infinite";
  EXPECT_NEAR(charts[0].series[1].y[1], 70.0, 1e-9) << "the 51st of 101, of which the largest 20 are infinite";
  EXPECT_EQ(charts[0].series[0].x, (std::vector{10.0, 10.0})) << "the band ends with its upper end";
  EXPECT_NO_THROW((void)svg_text(charts));
  const std::vector<Chart> curves = axis_charts(study_of({gap, records(5)}, compute));
  ASSERT_EQ(curves.size(), 1u);
  for (const Series& each : curves[0].series) EXPECT_EQ(each.x, (std::vector{10.0}));
  const std::vector<HeatMap> maps = heat_maps(study_of({gap, force, records(5)}, compute));
  ASSERT_EQ(maps.size(), 1u);
  EXPECT_TRUE(std::isnan(maps[0].values[0][1]));
  EXPECT_NO_THROW((void)svg_text(maps[0]));
  const auto all_fell = [](const StudyCase&) {
    return StudyRecord{{"drift", "storey 1", "m", 102.0}, {"collapsed", "", "1", 1.0}};
  };
  EXPECT_TRUE(axis_charts(study_of({gap, records(5)}, all_fell)).empty());
  EXPECT_TRUE(heat_maps(study_of({gap, force}, all_fell)).empty());
}

TEST(AxisCharts, LeaveOutCasesWithoutResults) {
  std::vector<CaseOutcome> outcomes(3);
  outcomes[0] = {.state = CaseState::done, .results = {{"x", "", "1", 1.0}}};
  outcomes[1] = {.state = CaseState::not_converged, .reason = "no"};
  const std::vector<Chart> charts = axis_charts(StudyResult{{gap}, outcomes});
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_EQ(charts[0].series[0].x, (std::vector{10.0}));
}

}  // namespace
}  // namespace moat
