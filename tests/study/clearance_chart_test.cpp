#include "study/clearance_chart.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace moat {
namespace {

StudyAxis three_records() {
  StudyAxis axis = StudyAxis::of_names("record", {"a", "b", "c"});
  axis.hashes = {"1", "2", "3"};
  return axis;
}

// Cases without results did not converge.
StudyResult solved(const StudyCases& cases, const std::function<StudyRecord(const StudyCase&)>& results_of) {
  std::vector<CaseOutcome> outcomes;
  for (std::size_t i = 0; i < cases.count(); ++i) {
    StudyRecord results = results_of(StudyCase{cases, i});
    const CaseState state = results.empty() ? CaseState::not_converged : CaseState::done;
    outcomes.push_back({.state = state, .reason = {}, .results = std::move(results), .files = {}});
  }
  return {cases, outcomes};
}

// The smallest of two gaps, in cm: 3, 1, -2 with lower properties, 6 and 4 with upper ones.
TEST(ClearanceChart, IsTheDistributionOfTheSmallestForEachBound) {
  const StudyResult study =
      solved({three_records(), StudyAxis::of_names("bounds", {"lower", "upper"})}, [](const StudyCase& each) {
        if (each.number() == 5) return StudyRecord{};
        const double left[] = {0.03, 0.06, 0.01, 0.04, -0.02};
        return StudyRecord{{"clearance_left", "moat left", "m", left[each.number()]},
                           {"clearance_left", "moat right", "m", 0.5}};
      });
  const std::optional<Chart> chart = clearance_chart(study);
  ASSERT_TRUE(chart.has_value());
  EXPECT_EQ(chart->x_label, "smallest clearance left [cm]");
  ASSERT_EQ(chart->series.size(), 2U);
  EXPECT_EQ(chart->series[0].name, "lower, 3 cases");
  EXPECT_EQ(chart->series[1].name, "upper, 2 cases, 1 without result");
  const std::vector x{-2.0, -2.0, 1.0, 1.0, 3.0, 3.0}, y{0.0, 1.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, 1.0};
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(chart->series[0].x.at(i), x[i], 1e-12);
    EXPECT_NEAR(chart->series[0].y.at(i), y[i], 1e-12);
  }
  EXPECT_EQ(chart->series[1].y, (std::vector{0.0, 0.5, 0.5, 1.0}));
  EXPECT_NE(svg_text({*chart}), "");
}

TEST(ClearanceChart, IsOneCurveWithoutBounds) {
  const std::optional<Chart> chart = clearance_chart(solved({three_records()}, [](const StudyCase& each) {
    return StudyRecord{{"clearance_left", "moat", "m", 0.01 * each.value("record")}};
  }));
  ASSERT_TRUE(chart.has_value());
  ASSERT_EQ(chart->series.size(), 1U);
  EXPECT_EQ(chart->series[0].name, "3 cases");
}

TEST(ClearanceChart, NeedsGapsAndASample) {
  const auto left = [](const StudyCase&) { return StudyRecord{{"clearance_left", "moat", "m", 0.1}}; };
  const StudyAxis gap{.name = "gap", .unit = "cm", .values = {10.0, 20.0}},
      direction{.name = "direction", .unit = "deg", .values = {0.0, 90.0}};
  EXPECT_FALSE(clearance_chart(solved({gap}, left)).has_value());
  EXPECT_FALSE(clearance_chart(solved({three_records(), gap}, left)).has_value());
  EXPECT_TRUE(clearance_chart(solved({three_records(), direction}, left)).has_value());
  EXPECT_FALSE(clearance_chart(solved({three_records()}, [](const StudyCase&) {
                 return StudyRecord{{"displacement", "base", "m", 0.1}};
               })).has_value());
}

}  // namespace
}  // namespace moat
