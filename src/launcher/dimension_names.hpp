// Names of types as a reader of scripts knows them.
#pragma once

#include <string>

namespace moat::launcher {

/// Puts names in the place of moat's types: "Mass" for `moat::Quantity<1, 0, 0>` and for a Required one of it, its unit
/// for a dimension without a name ("quantity in kg^2 m"), and no `moat::`.
std::string with_dimension_names(const std::string& text);

/// "a force [N]", "a number without unit", "a NodeId": a type in a sentence.
std::string described(const std::string& type);

}  // namespace moat::launcher
