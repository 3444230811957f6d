// How a value moves with several parameters, one at a time.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "output/files/table.hpp"

namespace moat {

/// The values where one parameter decreases and where it increases.
struct TornadoBar {
  std::string decrease, increase;                               ///< labels of the ends: "k/3", "3k"
  double decreased = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not known, then that end is not drawn
  double increased = std::numeric_limits<double>::quiet_NaN();  ///< as the other
};

/// A tornado chart: one bar for each parameter about the nominal value. Both ends of a bar may lie on one side of it.
struct Tornado {
  std::string title;                                        ///< Stands above the chart.
  std::string value_label;                                  ///< With unit: "displacement [cm]".
  double nominal = 0.0;                                     ///< Finite.
  double error = std::numeric_limits<double>::quiet_NaN();  ///< Numerical, >= 0; NaN: not known.
  std::vector<TornadoBar> bars{};                           ///< At least one, from the top down.
};

/// Returns the chart as SVG text, `width` pixels wide. It has the nominal value as a line with its numerical error at
/// the same scale, and bars from their lower to their higher end, both labelled. A filled disc marks the end where the
/// parameter increases, an open one the end where it decreases. Throws InputError without bars, for a nominal value
/// that is not finite, and for a width below 300 pixels.
std::string svg_text(const Tornado& tornado, int width = 500);

/// The numbers of the chart in one row, in the unit of the label: nominal value, error, and both ends of every bar
/// under their labels.
Table table_of(const Tornado& tornado);

}  // namespace moat
