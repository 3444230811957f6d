// Colours and sizes of charts.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace moat::chart_style {

inline constexpr const char* paper = "#ffffff";
inline constexpr const char* ink = "#262626";
inline constexpr const char* axis_line = "#5a5a5a";
inline constexpr const char* grid_line = "#e1e1e1";

/// Colours that stay apart for colour-blind readers (Okabe and Ito).
inline constexpr std::array<const char*, 7> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                    "#56b4e9", "#e69f00", "#000000"};
/// The one of them that cannot be seen on dark paper.
inline constexpr std::size_t black = 6;

// Names for style sheets. A chart states its colours, which are those for white paper; a page may replace them.
inline constexpr const char* paper_class = "chart-paper";
inline constexpr const char* ink_class = "chart-ink";
inline constexpr const char* axis_class = "chart-axis";
inline constexpr const char* grid_class = "chart-grid";
inline constexpr const char* black_line_class = "chart-black-line";
inline constexpr const char* black_mark_class = "chart-black-mark";

/// Rules of a style sheet for charts on dark paper; every other colour of the palette has a contrast of at least 3 : 1
/// on it.
inline constexpr std::string_view dark_rules = R"(.chart-paper { fill: #16181b; }
.chart-ink { fill: #dddddd; }
.chart-axis { stroke: #a0a0a0; }
.chart-grid { stroke: #3a3d42; }
.chart-black-line { stroke: #ffffff; }
.chart-black-mark { fill: #ffffff; }
)";

// Pixels.
inline constexpr double title_size = 16.0;
inline constexpr double label_size = 14.0;
inline constexpr double tick_size = 13.0;
inline constexpr double line_width = 1.6;
inline constexpr double marker_radius = 3.0;

inline constexpr double band_opacity = 0.35;

}  // namespace moat::chart_style
