// End an analysis whose results would mean nothing: one element chatters, or a building has collapsed.
#pragma once

#include <span>
#include <string>
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
  /// Writes or reads the counts.
  void archive(auto& archive) { archive(window_start_, changes_of_); }

 private:
  int largest_per_second_;
  double window_start_ = 0.0;                 // s
  std::vector<std::vector<int>> changes_of_;  // in this window, by block and element
};

/// Looks whether a building fell: second-order effects and softening storeys can leave it without lateral stiffness,
/// and its motion then grows without end. It has collapsed for certain where an element other than a contact deforms by
/// more than `largest_deformation`; the largest isolators move about 1 m.
class CollapseGuard {
 public:
  static constexpr double largest_deformation = 100.0;  ///< m

  /// Looks at the committed state.
  void look(const AnalysisState& state);
  /// Whether one was found.
  [[nodiscard]] bool collapsed() const { return !warning_.empty(); }
  /// Writes or reads whether one was found.
  void archive(auto& archive) { archive(warning_); }
  /// Names element and time; empty without a collapse.
  [[nodiscard]] const std::string& warning() const { return warning_; }

 private:
  std::string warning_;
};

}  // namespace moat
