// Charts as SVG, drawn without a display.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "output/files/table.hpp"

namespace moat {

/// A curve of a chart.
struct Series {
  /// How it is drawn.
  enum class Style {
    line,
    dashed,
    markers,
    band  ///< the inside of the closed line through the points: forth above, back below
  };

  std::string name{};  ///< in the legend; empty: not listed there
  /// Coordinates of its points, as many of both.
  std::vector<double> x{}, y{};
  Style style = Style::line;  ///< How it is drawn.
  /// Position in the palette of seven colours, from 0; by default that of the series in its chart.
  std::optional<std::size_t> colour = {};
};

/// A unit that readers know as well: g beside m/s^2.
struct SecondUnit {
  std::string symbol{};    ///< "g"
  double per_first = 1.0;  ///< > 0: a value in it = per_first * value
  bool of_x = false;       ///< of the values along x, instead of y
};

/// Curves over one pair of axes.
struct Chart {
  std::string title{};  ///< Stands above the chart.
  /// With units: "time [s]".
  std::string x_label{}, y_label{};
  std::vector<Series> series{};  ///< In the order of the legend.
  bool logarithmic_x = false;    ///< All x are then > 0.
  bool logarithmic_y = false;    ///< All y are then > 0.
  /// The y axis starts at zero, for values that are never negative; not together with logarithmic_y.
  bool y_from_zero = false;
  /// First and last x of the axis; points outside are not drawn. Without it the axis holds everything.
  std::optional<std::pair<double, double>> x_range = {};
  /// A second scale of the values, on the other side of the picture.
  std::optional<SecondUnit> second_unit = {};
};

/// The numbers of a chart: a column of x and one of y for every series, of a band one for each edge; x once where all
/// series share it. Shorter series end with values that are not a number. Quantity and unit come from the labels of the
/// axes: "displacement [cm]".
Table table_of(const Chart& chart);

/// The chart as SVG text, `width` x `height` pixels; several charts fill `columns` columns, row by row, each
/// `height` high, with their plot areas aligned. A legend that finds no room beside the title gets rows of its own,
/// which make its panel higher; texts that are longer than the plot area are shortened. Long series are thinned to
/// about two points per pixel and keep their peaks. Title and description say the same in words. The text has no
/// prolog and no ids, so it may be placed inside an HTML page, several times.
///
/// Throws InputError for no chart or a size below 200 x 150 pixels for each. It throws too where a chart has no point
/// to draw, a series has x and y of different length or a value that is not finite, or an x range ends before it
/// starts. A logarithmic axis refuses a value that is not positive, one from zero a negative one.
std::string svg_text(const std::vector<Chart>& charts, int width = 1000, int height = 420, int columns = 1);

/// Writes one chart. Throws as svg_text does, and FileError.
void write_svg(const Chart& chart, const std::filesystem::path& path, int width = 1000, int height = 420);

/// Writes several charts in columns, each `panel_height` high. Throws as svg_text does, and FileError.
void write_svg(const std::vector<Chart>& charts, const std::filesystem::path& path, int width = 1000,
               int panel_height = 300, int columns = 1);

}  // namespace moat
