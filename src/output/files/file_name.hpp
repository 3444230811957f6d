// Names of files made of titles.
#pragma once

#include <string>
#include <string_view>

namespace moat {

/// A title with small letters, digits and underscores alone: "Impacts over gap" -> "impacts_over_gap". "chart" for a
/// title without a letter or digit of ASCII.
std::string file_name_of(std::string_view title);

}  // namespace moat
