// A quantity that an element reports besides its deformation and force.
#pragma once

#include <string_view>

namespace moat {

/// The texts are literals: they live as long as the program.
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
