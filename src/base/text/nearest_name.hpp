// Misspelt names.
#pragma once

#include <string>
#include <vector>

namespace moat {

/// The name that differs from a misspelt one in the fewest letters; two neighbours that are swapped count as one. It
/// differs in at most three letters, and in at most a third of the letters of the longer word. Empty if none is so
/// near. Give options without their dashes: these would count as letters.
std::string nearest_name(const std::vector<std::string>& names, const std::string& misspelt);

/// " Did you mean --gap?" with the nearest name behind `dashes`; empty if none is near.
std::string did_you_mean(const std::vector<std::string>& names, const std::string& misspelt,
                         const std::string& dashes = "");

}  // namespace moat
