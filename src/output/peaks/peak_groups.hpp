// Peaks of one quantity together, ready to print.
#pragma once

#include <string>
#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

/// One place of a quantity, as text.
struct PeakRow {
  std::string where;    ///< node or element
  std::string value;    ///< in the group's unit
  std::string missing;  ///< decimals that other values of the group have and this one has not: ".00"
  std::string error;    ///< in the group's unit; empty where it is not known
  std::string time;     ///< s
  std::string side;     ///< "left", "right", or the element that reached it
};

/// The places of one quantity.
struct PeakGroup {
  std::string quantity;       ///< in words
  std::string unit;           ///< engineering unit
  std::vector<PeakRow> rows;  ///< in the order of the peaks
};

/// Groups by quantity and unit, in the order they first appear. A group's largest value has 4 significant digits and
/// the others as many decimals, but no digit beyond those of the error: 53.28 with 0.02, 53.3 with 0.4, 2560 with 30.
std::vector<PeakGroup> group_peaks(const std::vector<Peak>& peaks);

/// The clearances left, in the same way; the side of a row is the clearance at rest: "of 10 cm".
PeakGroup clearance_group(const std::vector<GapClearance>& clearances);

}  // namespace moat
