// Which results of a study are responses of the structure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/result.hpp"

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

/// One number for every case.
struct StudyResponse {
  std::string quantity;        ///< "displacement"
  std::string title;           ///< "Largest displacement"
  std::string label;           ///< "displacement [cm]"
  std::vector<double> values;  ///< in the unit of the label; NaN of cases without results
};

/// The first eight responses of a study, those of pounding first: of every quantity the largest value of all places,
/// of clearances the smallest. A case that collapsed counts as infinite, except in quantities of pounding.
std::vector<StudyResponse> responses_of(const StudyResult& study);

}  // namespace moat
