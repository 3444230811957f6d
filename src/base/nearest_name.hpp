// Misspelt names.
#pragma once

#include <string>
#include <vector>

namespace moat {

/// The name that differs in the fewest letters from a misspelt one: in at most a third of its letters, and one more.
/// Empty if none is so near.
std::string nearest_name(const std::vector<std::string>& names, const std::string& misspelt);

}  // namespace moat
