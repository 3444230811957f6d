// Peaks of one quantity together, ready to print.
#pragma once

#include <string>
#include <vector>

#include "output/case_result.hpp"

namespace moat {

struct PeakRow {
  std::string where;
  std::string value;  ///< in the group's unit
  std::string time;   ///< s
};

struct PeakGroup {
  std::string quantity;  ///< in words
  std::string unit;      ///< engineering unit
  std::vector<PeakRow> rows;
};

/// Groups by quantity and unit, in the order they first appear. Within a group every value has the same decimals.
std::vector<PeakGroup> group_peaks(const std::vector<Peak>& peaks);

}  // namespace moat
