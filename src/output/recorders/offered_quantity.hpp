// A quantity that a recorder of the script offers.
#pragma once

#include <string>

namespace moat {

/// Quantity and place together are unique in a run.
struct OfferedQuantity {
  std::string quantity;  ///< "roof_tilt"; files write it as it is, the report with blanks
  std::string where;     ///< "tower"
  std::string unit;      ///< SI symbol; "1" without dimension
};

}  // namespace moat
