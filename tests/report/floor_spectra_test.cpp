#include "report/charts/result_charts.hpp"

#include <gtest/gtest.h>

#include "report_testing.hpp"

namespace moat {
namespace {

FloorSpectrum spectrum_of(const std::string& floor, const std::string& corner, const std::string& direction,
                          double damping_ratio) {
  return {floor, corner, direction, {damping_ratio, {0.1, 1.0}, {}, {4.0, 2.0}, {}}};
}

TEST(FloorSpectraCharts, OneForEachDampingShowsAllFloors) {
  CaseResult result;
  EXPECT_TRUE(floor_spectra(result).empty());
  for (const char* floor : {"base", "floor 5"})
    for (const double damping_ratio : {0.02, 0.05})
      result.floor_spectra.push_back(spectrum_of(floor, "", "", damping_ratio));
  const std::vector<Chart> charts = floor_spectra(result);
  ASSERT_EQ(charts.size(), 2u);
  EXPECT_EQ(charts[0].title, "Floor response spectra");
  EXPECT_EQ(charts[0].x_label, "period of an oscillator with 2 % damping [s]");
  EXPECT_EQ(charts[1].x_label, "period of an oscillator with 5 % damping [s]");
  for (const Chart& chart : charts) {
    ASSERT_EQ(chart.series.size(), 2u);
    EXPECT_EQ(chart.series[1].name, "floor 5");
    EXPECT_EQ(chart.series[1].x, (std::vector<double>{0.1, 1.0}));
    EXPECT_EQ(chart.series[1].y, (std::vector<double>{4.0, 2.0}));
  }
}

TEST(FloorSpectraCharts, OneForEachDirectionShowsCentresInPlan) {
  CaseResult result;
  for (const char* corner : {"", "corner 1"})
    for (const char* direction : {"x", "y"})
      result.floor_spectra.push_back(spectrum_of("base", corner, direction, 0.05));
  const std::vector<Chart> charts = floor_spectra(result);
  ASSERT_EQ(charts.size(), 2u);
  EXPECT_EQ(charts[0].title, "Floor response spectra along x");
  EXPECT_EQ(charts[1].title, "Floor response spectra along y");
  EXPECT_EQ(charts[0].series.size(), 1u);
}

TEST(FloorSpectraCharts, ARunHasThemOfBaseAndTop) {
  const std::vector<Chart> charts = floor_spectra(testing_report::plan_result());
  ASSERT_EQ(charts.size(), 2u);
  ASSERT_EQ(charts[1].series.size(), 2u);
  EXPECT_EQ(charts[1].series[0].name, "base");
  EXPECT_EQ(charts[1].series[1].name, "floor 1");
}

}  // namespace
}  // namespace moat
