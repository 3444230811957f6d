// Peaks of one quantity together, ready to print.
#pragma once

#include <string>
#include <vector>

#include "output/case_result.hpp"

namespace moat {

struct PeakRow {
  std::string where;
  std::string value;    ///< in the group's unit
  std::string missing;  ///< decimals that other values of the group have and this one has not: ".00"
  std::string error;    ///< in the group's unit; empty where it is not known
  std::string time;     ///< s
};

struct PeakGroup {
  std::string quantity;  ///< in words
  std::string unit;      ///< engineering unit
  std::vector<PeakRow> rows;
};

/// Groups by quantity and unit, in the order they first appear. A group's largest value has 4 significant digits and
/// the others as many decimals, but no digit beyond those of the error: 53.28 with 0.02, 53.3 with 0.4, 2560 with 30.
std::vector<PeakGroup> group_peaks(const std::vector<Peak>& peaks);

}  // namespace moat
