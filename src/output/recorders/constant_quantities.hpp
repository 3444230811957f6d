// Quantities that need no peak.
#pragma once

#include <set>
#include <string>

#include "output/files/table.hpp"

namespace moat {

/// The quantities of a table of histories that never change, at any place, and are not zero: the coefficient of a
/// friction that depends on nothing. They have no peak to show.
std::set<std::string> constant_quantities(const Table& histories);

}  // namespace moat
