// A value over two parameters, as coloured cells.
#pragma once

#include <string>
#include <vector>

namespace moat {

/// Cells from left to right and from bottom to top.
struct HeatMap {
  std::string title;  ///< Stands above the chart.
  /// With units: "gap [cm]".
  std::string x_label, y_label;
  std::string value_label;  ///< with unit: "drift [cm]"
  /// Names of columns and rows, at least one each.
  std::vector<std::string> x_values, y_values;
  /// values[row][column]; NaN: none, drawn in grey.
  std::vector<std::vector<double>> values;
};

/// The colour at a share from 0 to 1 of a range, "#rrggbb". Colours grow in brightness and stay apart for colour-blind
/// readers (viridis).
std::string viridis(double share);

/// The map as SVG text with a colour scale, `width` x `height` pixels; wide cells show their value. Throws InputError
/// where rows or columns do not fit their names, where no value is finite, and for a size below 300 x 200 pixels.
std::string svg_text(const HeatMap& map, int width = 800, int height = 480);

}  // namespace moat
