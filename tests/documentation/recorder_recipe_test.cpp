// The recipe "How to add a recorder with a chart" of CONTRIBUTING.md.

#include <gtest/gtest.h>

#include "analyses/case/case_run.hpp"
#include "elements/line/shear_spring.hpp"
#include "output/recorders/separation_recorder.hpp"
#include "report/charts/result_charts.hpp"
#include "small_models.hpp"

namespace moat::testing {
namespace {

using namespace units;

TEST(RecorderRecipe, AppearsInHistoriesPeaksAndCharts) {
  Model model;
  const NodeId left = add(model, Node{.name = "left", .mass = 1 * kg, .free = true});
  const NodeId right = add(model, Node{.name = "right", .mass = 1 * kg, .initial_displacement = 3 * cm});
  add(model, ShearSpring{.name = "spring", .lower = ground, .upper = right, .stiffness = 100 * N / m});
  CaseRun run{model, still_ground(1 * s)};
  SeparationRecorder separation{"gap", left, right};
  run.attach(separation);
  run.run();
  const CaseResult result = run.result();
  const auto peak = std::ranges::find(result.peaks, "separation", &Peak::quantity);
  ASSERT_NE(peak, result.peaks.end());
  EXPECT_NEAR(peak->magnitude(), 0.03, 1e-6);
  const auto column = std::ranges::find(result.histories.columns, "separation", &Column::quantity);
  ASSERT_NE(column, result.histories.columns.end());
  EXPECT_EQ(column->values.front(), 0.03);
  const std::vector<Chart> charts = history_charts(result);
  EXPECT_TRUE(std::ranges::any_of(charts, [](const Chart& chart) { return chart.title == "Separation"; }));
}

}  // namespace
}  // namespace moat::testing
