// Names of the parts of a model.
#pragma once

#include <string_view>

#include "base/check.hpp"

namespace moat {

/// Throws InputError for a name that tables cannot hold: one that is not UTF-8, or that a spreadsheet takes for a
/// formula.
void check_name(const Check& check, std::string_view name);

}  // namespace moat
