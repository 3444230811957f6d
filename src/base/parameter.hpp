// Named numbers and quantities of a model, as reports print them.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace moat {

/// One parameter of a law, an element or an analysis. The texts are literals: they live as long as the program.
struct Parameter {
  std::string_view name;  ///< as scripts write it: "stiffness"
  double value = 0.0;     ///< in the unit; a choice between yes and no is 1 or 0
  std::string_view unit;  ///< SI: "N/m^1.5"; "1" without dimension

  friend bool operator==(const Parameter&, const Parameter&) = default;
};

/// Returns the value of a parameter, or `otherwise` where the list does not have it.
inline double parameter_of(const std::vector<Parameter>& list, std::string_view name, double otherwise = 0.0) {
  const auto found = std::ranges::find(list, name, &Parameter::name);
  return found == list.end() ? otherwise : found->value;
}

/// A quantity that an element reports besides its deformation and force. The texts are literals, as those of a
/// parameter.
struct ReportedQuantity {
  std::string_view name;  ///< "friction_coefficient"; files write it as it is, the report with blanks
  std::string_view unit;  ///< SI; "1" without dimension
};

/// Such a quantity at an instant.
struct ReportedValue {
  double value = 0.0;  ///< in its unit
  double rate = 0.0;   ///< per second
};

}  // namespace moat
