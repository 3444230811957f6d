// Peaks as people read them.
#pragma once

#include <functional>
#include <map>
#include <set>
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
  std::string second;   ///< the value in the group's second unit; empty where it has none
  std::string time;     ///< s
  std::string side;     ///< "left", "right", or the element that reached it
  double size = 0.0;    ///< magnitude of the value in SI units; of a clearance itself
};

/// The places of one quantity.
struct PeakGroup {
  std::string quantity;       ///< in words
  std::string unit;           ///< engineering unit
  std::string second_unit;    ///< "g" of accelerations; empty for other quantities
  std::vector<PeakRow> rows;  ///< in the order of the peaks
};

/// The groups of a result that tables show: without quantities that are constant in the histories, without gaps that
/// stayed open, and without those of single bearings in plan, which have a table of their own. `shorten` gets each
/// group before the next is made.
std::vector<PeakGroup> groups_of_tables(const CaseResult& result, const std::function<void(PeakGroup&)>& shorten);

/// The bearings whose peaks are listed together with those of others: elements of the model, by their names.
std::map<std::string, const ElementFacts*> single_bearings(const ModelFacts& model);

/// Groups by quantity and unit, in the order they first appear. A group's largest value has 4 significant digits and
/// the others as many decimals, but no digit beyond those of the error: 53.28 with 0.02, 53.3 with 0.4, 2560 with 30.
std::vector<PeakGroup> group_peaks(const std::vector<Peak>& peaks);

/// The clearances left, in the same way; the side of a row is the clearance at rest: "of 10 cm".
PeakGroup clearance_group(const std::vector<GapClearance>& clearances);

/// The deformation of every isolator in the last row of the histories, m, with the time of that row: its residual
/// offset, if the building has come to rest. In plan its length. Empty without histories.
std::vector<Peak> isolators_at_the_end(const Table& histories);

/// The `residual_displacement` of every isolator, m, with the time of the last row; in the order of
/// isolators_at_the_end(), in plan the length of its components. It is the deformation in the last row or, where the
/// isolator still moves faster than 0.1 mm/s in the last half period, the mean of its last two turns; `side` is "still
/// moving" then. The mean needs free vibration of at least two periods behind the motion.
std::vector<Peak> residual_displacements(const Table& histories);

/// The quantities of a table of histories that never change, at any place, and are not zero: the coefficient of a
/// friction that depends on nothing. They have no peak to show.
std::set<std::string> constant_quantities(const Table& histories);

/// An error rounded up to one significant digit, to two if the first is 1: 0.0204 -> "0.03", 0.0113 -> "0.012".
struct RoundedError {
  std::string text;  ///< empty for an error that is not known
  /// Decimal place of its last digit; negative where that is 10, 100 ... A value has no more digits than this. Very
  /// many for an error of zero or one that is not known.
  int decimals = 0;
};

/// `error` >= 0, in any unit; not finite if it is not known.
RoundedError rounded_error(double error);

/// `value` rounded to so many decimals: 2563 to -1 is 2560.
double rounded_to(double value, int decimals);

}  // namespace moat
