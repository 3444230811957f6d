#include "output/charts/chart_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "output/charts/svg_writer.hpp"

namespace moat {
namespace {

std::vector<std::string> labels_of(const ChartAxis& axis) {
  std::vector<std::string> labels;
  for (const AxisTick& tick : axis.ticks) labels.push_back(tick.label);
  return labels;
}

using Labels = std::vector<std::string>;

TEST(ChartAxis, EndsAtRoundValuesThatHoldTheRange) {
  const ChartAxis axis = axis_around({-33.2, 31.5}, false, AxisSide::left, 160.0);
  EXPECT_EQ(axis.low, -40.0);
  EXPECT_EQ(axis.high, 40.0);
  EXPECT_EQ(labels_of(axis), (Labels{"−40", "−20", "0", "20", "40"}));
  EXPECT_DOUBLE_EQ(axis.share(-40.0), 0.0);
  EXPECT_DOUBLE_EQ(axis.share(20.0), 0.75);
}

TEST(ChartAxis, HasNoStepsBelowTheSmallestNumbers) {
  const ChartAxis axis = axis_around({-5e-324, 1e-300}, false, AxisSide::left, 160.0);
  EXPECT_EQ(axis.low, -1.0);
  EXPECT_EQ(axis.high, 1.0);
}

TEST(ChartAxis, KeepsAGivenRange) {
  const ChartAxis axis = axis_over({0.3, 2.6}, false, AxisSide::bottom, 450.0);
  EXPECT_EQ(axis.low, 0.3);
  EXPECT_EQ(axis.high, 2.6);
  EXPECT_EQ(labels_of(axis), (Labels{"0.5", "1.0", "1.5", "2.0", "2.5"}));
}

TEST(ChartAxis, LabelsLargeAndSmallNumbersWithOneExponent) {
  EXPECT_EQ(labels_of(axis_over({0.0, 3e8}, false, AxisSide::left, 240.0)),
            (Labels{"0", "0.5e8", "1.0e8", "1.5e8", "2.0e8", "2.5e8", "3.0e8"}));
  EXPECT_EQ(labels_of(axis_over({0.0, 3e-6}, false, AxisSide::left, 120.0)), (Labels{"0", "1e-6", "2e-6", "3e-6"}));
  EXPECT_EQ(labels_of(axis_over({1e7, 1e9}, true, AxisSide::bottom, 100.0)), (Labels{"1e7", "1e8", "1e9"}));
}

TEST(ChartAxis, HasDecadesAndTheirPartsWhereThereIsRoom) {
  const ChartAxis wide = axis_around({0.013, 1.7}, true, AxisSide::bottom, 600.0);
  EXPECT_EQ(wide.low, 0.01);
  EXPECT_EQ(wide.high, 2.0);
  EXPECT_EQ(labels_of(wide), (Labels{"0.01", "0.02", "0.05", "0.1", "0.2", "0.5", "1", "2"}));
  EXPECT_DOUBLE_EQ(wide.share(0.1), std::log(10.0) / std::log(200.0));
  EXPECT_EQ(labels_of(axis_around({0.013, 1.7}, true, AxisSide::bottom, 200.0)), (Labels{"0.01", "0.1", "1"}));
  const ChartAxis many = axis_around({1e-9, 1e9}, true, AxisSide::left, 100.0);
  EXPECT_EQ(labels_of(many), (Labels{"1e-8", "0.0001", "1", "10000", "1e8"}));
  // No decade and none of its parts is inside.
  EXPECT_GE(axis_over({0.31, 0.42}, true, AxisSide::bottom, 400.0).ticks.size(), 2u);
}

TEST(ChartAxis, LabelsNeverOverlap) {
  for (const double length : {60.0, 110.0, 350.0, 900.0})
    for (const double largest : {1.0, 7.3, 123456.0, 999999.0, 1e6, 3.3e12})
      for (const double lowest : {0.0, -0.4 * largest, -largest, 0.98 * largest}) {
        const ChartAxis axis = axis_around({lowest, largest}, false, AxisSide::bottom, length);
        EXPECT_LE(axis.low, lowest);
        EXPECT_GE(axis.high, largest);
        ASSERT_GE(axis.ticks.size(), 2u);
        if (axis.ticks.size() == 2) continue;  // shown however long they are
        double end = -1e9;
        for (const AxisTick& tick : axis.ticks) {
          const double width = text_width(tick.label, chart_style::tick_size);
          const double start = length * axis.share(tick.value) - 0.5 * width;
          EXPECT_GT(start, end) << tick.label << " of " << lowest << " to " << largest;
          end = start + width;
        }
      }
}

TEST(ChartAxis, HasRoundNumbers) {
  for (const auto& [value, expected] :
       {std::pair{0.0199, 0.01}, {1.0, 1.0}, {2.0, 2.0}, {4.9, 2.0}, {7.0, 5.0}, {1000.0, 1000.0}, {499.0, 200.0}})
    EXPECT_DOUBLE_EQ(round_number_below(value), expected) << value;
}

TEST(ChartAxis, HoldsARangeOfOneValue) {
  EXPECT_EQ(labels_of(axis_around({0.0, 0.0}, false, AxisSide::left, 80.0)), (Labels{"−1", "0", "1"}));
  const ChartAxis constant = axis_around({5.0, 5.0}, false, AxisSide::left, 200.0);
  EXPECT_EQ(constant.low, 0.0);
  EXPECT_GT(constant.high, 5.0);
  const ChartAxis logarithmic = axis_around({5.0, 5.0}, true, AxisSide::left, 200.0);
  EXPECT_EQ(logarithmic.low, 5.0);
  EXPECT_EQ(logarithmic.high, 50.0);
}

}  // namespace
}  // namespace moat
