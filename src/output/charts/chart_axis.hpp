// The axis of a chart: its range, its ticks, and the place of a value on it.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace moat {

struct AxisTick {
  double value;
  std::string label;
};

/// A range of values with ticks.
struct ChartAxis {
  double low = 0.0, high = 1.0;
  bool logarithmic = false;
  std::vector<AxisTick> ticks = {};  ///< ascending, all inside the range

  /// 0 at the lower end, 1 at the upper end.
  [[nodiscard]] double share(double value) const;
};

/// Where an axis stands: labels of a bottom one lie side by side, those of a left one above each other.
enum class AxisSide { bottom, left };

/// An axis from low to high, low < high (both > 0 if logarithmic), of `length` pixels, with ticks at round values whose
/// labels do not overlap.
ChartAxis axis_over(std::pair<double, double> range, bool logarithmic, AxisSide side, double length);

/// Such an axis with ends at round values that hold the range. Low may equal high here.
ChartAxis axis_around(std::pair<double, double> range, bool logarithmic, AxisSide side, double length);

/// The largest of 1, 2, 5 times a power of ten that is at most value > 0.
double round_number_below(double value);

}  // namespace moat
