// Peaks of a result by their names.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "output/files/case_result.hpp"

namespace moat::testing {

/// The peak of a quantity at a place, or at the first place that has it where none is named. Fails the test if there is
/// none; its value is then no number.
inline Peak peak_in(const CaseResult& result, std::string_view quantity, std::string_view where = {}) {
  for (const Peak& peak : result.peaks)
    if (peak.quantity == quantity && (where.empty() || peak.where == where)) return peak;
  ADD_FAILURE() << "There is no peak of " << quantity << " at \"" << where << "\".";
  Peak none;
  none.value = std::nan("");
  return none;
}

/// Its magnitude.
inline double peak(const CaseResult& result, std::string_view quantity, std::string_view where = {}) {
  return peak_in(result, quantity, where).magnitude();
}

}  // namespace moat::testing
