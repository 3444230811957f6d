// A report as HTML: its pieces, and the page around them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text/utf8_text.hpp"
#include "output/charts/chart.hpp"

namespace moat::html {

/// Text as HTML, in UTF-8.
inline std::string escaped(std::string_view text) { return escaped_for_xml(text); }
/// A cell of a table, with a text that is escaped.
inline std::string cell(std::string_view text) { return "<td>" + escaped(text) + "</td>"; }

/// A row of a table with a name and a number; both are escaped.
std::string number_row(std::string_view name, std::string_view value);
/// A row of a table with a name and a text; both are escaped.
std::string text_row(std::string_view name, std::string_view value);

/// In the engineering unit with 4 significant digits, 2 if it is very small, and accelerations in g as well: "12.35
/// cm", "1.2e-09 kJ", "3.923 m/s^2 (0.4 g)" with a raised 2.
std::string number_with_unit(double value_in_si, std::string_view si_symbol);

/// Every chart as a picture of its own, `width` by `height` pixels: side by side where there is room, below each other
/// on a phone, where letters of one wide picture could not be read.
std::string chart_grid(const std::vector<Chart>& charts, int width, int height);

/// A picture as wide as the page; on a phone it keeps a readable size and scrolls sideways.
std::string wide_picture(const std::string& svg);

/// A whole page that needs nothing else, no network and no other file. title: plain text; body: HTML.
std::string page(std::string_view title, std::string_view body);

/// Such a page with the script that moves the drawing and zooms the histories of a run. data: JSON
/// (report/page_data.hpp).
std::string page_with_script(std::string_view title, std::string_view body, std::string_view data);

}  // namespace moat::html
