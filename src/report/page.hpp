// The frame of a report: head, style, heading and script of an HTML page.
#pragma once

#include <string>
#include <string_view>

namespace moat::html {

/// A whole page that needs nothing else, no network and no other file. title: plain text; body: HTML.
std::string page(std::string_view title, std::string_view body);

/// Such a page with the script that moves the drawing and zooms the histories of a run. data: JSON
/// (report/page_data.hpp).
std::string page_with_script(std::string_view title, std::string_view body, std::string_view data);

}  // namespace moat::html
