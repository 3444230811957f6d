// A building without lateral stiffness falls, and the analysis says so.

#include <gtest/gtest.h>

#include <cmath>

#include "analysis_testing.hpp"
#include "in_folder.hpp"
#include "moat.hpp"
#include "output/files/summary.hpp"
#include "peak_in.hpp"
#include "report/report.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

// The yielding storey keeps 0.8 MN/m, its weight takes 1.6 MN/m.
Model building() {
  Model model;
  const NodeId floor = add(model, Node{.name = "floor", .mass = 500 * tonne});
  add(model,
      Storey<YieldingStorey>{.name = "storey",
                             .lower = ground,
                             .upper = floor,
                             .law = {.stiffness = 40 * MN / m, .yield_force = 0.4 * MN, .hardening_ratio = 0.02}});
  add(model,
      Spring<PDelta>{.name = "weight", .lower = ground, .upper = floor, .law = {.weight = 4.9 * MN, .height = 3 * m}});
  return model;
}

CaseResult run(double pull, TransientOptions options = {}, ErrorBarMode error_bars = ErrorBarMode::automatic) {
  Model model = building();
  return run_case(model, constant_acceleration(pull, 60 * s), {.transient = options, .error_bars = error_bars});
}

double peak_drift(const CaseResult& result) { return peak(result, "drift"); }

TEST(Collapse, EndsTheAnalysisWithAWarning) {
  for (const Integrator& integrator : {Integrator{Newmark{}}, Integrator{ExactBetweenEvents{}}}) {
    const CaseResult result = run(2.0, {.integrator = integrator});
    ASSERT_FALSE(result.warnings.empty());
    EXPECT_EQ(result.warnings.front().find("The model collapsed: at t = "), 0U) << result.warnings.front();
    EXPECT_NE(result.warnings.front().find("\"storey\""), std::string::npos) << result.warnings.front();
    EXPECT_GT(peak_drift(result), CollapseGuard::largest_deformation);
    EXPECT_LT(peak_drift(result), 2.0 * CollapseGuard::largest_deformation);
    EXPECT_LT(result.histories.values("time").back(), 60.0);
  }
}

TEST(Collapse, IsSeenBeforeItEndsTheAnalysis) {
  const double fallen = run(2.0).histories.values("time").back();
  // It grows by a factor e in about 0.8 s.
  const CaseResult result = run(2.0, {.end = (fallen - 1.5) * s});
  EXPECT_GT(peak_drift(result), 3.0);
  EXPECT_LT(peak_drift(result), CollapseGuard::largest_deformation);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_EQ(result.warnings.front().find("The model collapsed: the drift of \"storey\" reached "), 0U)
      << result.warnings.front();
}

TEST(Collapse, IsNotSeenWhereTheBuildingStands) {
  const CaseResult result = run(0.3);
  EXPECT_LT(peak_drift(result), 0.02);
  for (const std::string& warning : result.warnings) EXPECT_EQ(warning.find("collapse"), std::string::npos) << warning;
}

// Where the fall is stopped follows from its steps: both runs would agree by chance alone.
TEST(Collapse, LeavesNoPeakAnErrorBar) {
  for (const ErrorBarMode mode : {ErrorBarMode::automatic, ErrorBarMode::always, ErrorBarMode::never}) {
    const CaseResult result = run(2.0, {}, mode);
    for (const Peak& peak : result.peaks) EXPECT_TRUE(std::isnan(peak.error)) << peak.quantity;
    EXPECT_FALSE(result.error_bars.checked);
    EXPECT_FALSE(result.error_bars.unsettled);
    EXPECT_EQ(result.error_bars.companion,
              mode == ErrorBarMode::never
                  ? "No error bars: they were not wanted (CaseOptions::error_bars)."
                  : "No error bars: the model collapsed, and peaks of a fall depend on where it is stopped.");
  }
  EXPECT_TRUE(run(0.3, {}, ErrorBarMode::always).error_bars.checked);
}

TEST(Collapse, IsNotJudgedInAStudyEither) {
  Model model = building();
  const StudyRecord record = peaks_of(model, constant_acceleration(2.0, 60 * s), {}, true);
  EXPECT_TRUE(std::isnan(value_of(record, "unsettled", "")));
  EXPECT_TRUE(std::isnan(value_of(record, "drift_error", "storey")));
  EXPECT_GT(value_of(record, "drift", "storey"), 100.0);
}

using CollapseFiles = InFolder;

TEST_F(CollapseFiles, SayThatTheErrorsAreNotKnown) {
  const CaseResult result = run(2.0, {}, ErrorBarMode::always);
  write_summary_json(result, folder / "summary.json");
  write_report_html(result, result_charts(result), folder);
  const std::string summary = read_file(folder / "summary.json"), report = read_file(folder / "report.html");
  EXPECT_NE(summary.find("\"error\": null"), std::string::npos);
  EXPECT_NE(summary.find("\"unsettled\": null"), std::string::npos);
  for (const std::string& text : {summary, report}) {
    EXPECT_NE(text.find("No error bars: the model collapsed"), std::string::npos);
    EXPECT_EQ(text.find(">nan"), std::string::npos);
  }
}

// A body that flies is none.
TEST(Collapse, IsNotSeenInABodyThatFlies) {
  Model model;
  add(model, Node{.name = "body", .mass = 1 * kg, .initial_velocity = 10 * m / s});
  Transient analysis{model, still_ground(60 * s)};
  analysis.run();
  EXPECT_NEAR(analysis.state().motion().displacement[0], 600.0, 1e-6);
}

}  // namespace
}  // namespace moat
