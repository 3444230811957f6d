// The frame of a report: head, style and heading of an HTML page.
#pragma once

#include <string>
#include <string_view>

namespace moat::html {

/// A whole page that needs nothing else. title: plain text; body: HTML.
std::string page(std::string_view title, std::string_view body);

}  // namespace moat::html
