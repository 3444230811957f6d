// The dimension of a value, read from its text in a script.
#pragma once

#include <string>

namespace moat::launcher {

/// The type of a product of numbers and units: "Quantity<1, 2, -2>" for `100 * MN`, "int" for `5`, "double" for `5.0`.
/// Empty for any other expression.
std::string type_of_product(const std::string& value);

/// Whether the text is a number.
bool is_number(const std::string& value);

}  // namespace moat::launcher
