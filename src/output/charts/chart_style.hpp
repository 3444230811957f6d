// Colours and sizes of charts.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace moat::chart_style {

/// A colour on white paper, and its class, for which the style sheet of a page may have another colour.
struct Paint {
  std::string_view colour, kind = {};
};

inline constexpr Paint paper{"#ffffff", "chart-paper"}, ink{"#262626", "chart-ink"}, axis_line{"#5a5a5a", "chart-axis"},
    grid_line{"#e1e1e1", "chart-grid"};

/// Colours that stay apart for colour-blind readers (Okabe and Ito).
inline constexpr std::array<Paint, 7> palette{
    {{"#0072b2"}, {"#d55e00"}, {"#009e73"}, {"#cc79a7"}, {"#56b4e9"}, {"#e69f00"}, {"#000000", "chart-black"}}};

/// Rules of a style sheet for charts on dark paper; every other colour of the palette has a contrast of at least 3 : 1
/// on it.
inline constexpr std::string_view dark_rules = R"(.chart-paper { fill: #16181b; }
.chart-ink { fill: #dddddd; }
.chart-axis { stroke: #a0a0a0; }
.chart-grid { stroke: #3a3d42; }
polyline.chart-black { stroke: #ffffff; }
polygon.chart-black, circle.chart-black { fill: #ffffff; }
)";

// Pixels.
inline constexpr double title_size = 16.0, label_size = 14.0, tick_size = 13.0, line_width = 1.6, marker_radius = 3.0;

inline constexpr double band_opacity = 0.35;

}  // namespace moat::chart_style
