#include "report/charts/result_charts.hpp"

#include <gtest/gtest.h>

#include <set>

#include "in_folder.hpp"
#include "report_testing.hpp"

namespace moat {
namespace {

class ResultChartFiles : public testing::InFolder {};

TEST_F(ResultChartFiles, EveryChartIsAPictureWithItsNumbers) {
  const CaseResult result = testing_report::line_result();
  const ResultCharts charts = result_charts(result);
  write_charts(charts, folder);
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{folder / "charts"})
    names.insert(entry.path().filename().string());
  EXPECT_EQ(names.size(), 2 * charts.all().size());
  for (const char* name : {"displacement", "absolute_acceleration", "impact_force", "drift_over_height",
                           "loops_of_the_isolators", "energy", "floor_response_spectra"})
    for (const char* extension : {".svg", ".csv"}) EXPECT_TRUE(names.contains(std::string{name} + extension)) << name;
  EXPECT_TRUE(std::filesystem::exists(folder / "charts.svg"));
  EXPECT_TRUE(testing::read_file(folder / "charts" / "displacement.csv")
                  .starts_with("time [s],displacement [cm] base,displacement [cm] floor 2\n0,0,0\n"));
}

TEST_F(ResultChartFiles, ChartsOfOneTitleHaveFilesOfTheirOwn) {
  const Chart chart{.title = "Same (title)", .x_label = "x", .y_label = "y", .series = {{"", {0.0, 1.0}, {0.0, 1.0}}}};
  ResultCharts charts;
  charts.histories = {chart, chart};
  write_charts(charts, folder);
  EXPECT_TRUE(std::filesystem::exists(folder / "charts" / "same_title.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder / "charts" / "same_title_2.csv"));
}

TEST_F(ResultChartFiles, NothingIsWrittenWithoutCharts) {
  write_charts(result_charts({}), folder);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace moat
