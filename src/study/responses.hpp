// Which results of a study are responses of the structure.
#pragma once

#include <string_view>

namespace moat {

/// Whether charts and statistics show a quantity: no errors, energies or answers of other questions.
inline bool is_response(std::string_view quantity) {
  return !quantity.ends_with("_error") && !quantity.starts_with("energy_") && !quantity.starts_with("ida_") &&
         quantity != "unsettled" && quantity != "collapsed";
}

/// Whether it exists after a collapse too, as results at gaps do.
inline bool is_of_pounding(std::string_view quantity) {
  return quantity == "clearance_left" || quantity == "impacts" || quantity.starts_with("impact_");
}

}  // namespace moat
