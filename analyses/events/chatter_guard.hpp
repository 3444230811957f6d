// Ends an analysis in which one element changes its regime again and again.
#pragma once

#include <span>
#include <vector>

#include "model/analysis_state.hpp"

namespace moat {

/// Counts the changes of every element in windows of a second, one after the other. Many gaps may close in one second;
/// one that closes thousands of times chatters.
class ChatterGuard {
 public:
  /// Changes of one element's regime in one second, > 0.
  explicit ChatterGuard(int largest_per_second) : largest_per_second_{largest_per_second} {}

  /// Throws Error that names the element, if one changed too often.
  void count(const AnalysisState& state, std::span<const RegimeChange> changes);

 private:
  int largest_per_second_;
  double window_start_ = 0.0;                 // s
  std::vector<std::vector<int>> changes_of_;  // in this window, by block and element
};

}  // namespace moat
