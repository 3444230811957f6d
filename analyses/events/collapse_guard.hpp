// Ends an analysis in which a building has collapsed.
#pragma once

#include <string>

#include "model/analysis_state.hpp"

namespace moat {

/// Looks whether a building fell: second-order effects and softening storeys can leave it without lateral stiffness,
/// and its motion then grows without end. It has collapsed for certain where an element other than a contact deforms by
/// more than `largest_deformation`; the largest isolators move about 1 m.
class CollapseGuard {
 public:
  static constexpr double largest_deformation = 100.0;  ///< m

  /// Looks at the committed state.
  void look(AnalysisState& state);
  /// Whether one was found.
  [[nodiscard]] bool collapsed() const { return !warning_.empty(); }
  /// Names element and time; empty without a collapse.
  [[nodiscard]] const std::string& warning() const { return warning_; }

 private:
  void look_at_elements(const AnalysisState& state);

  std::string warning_;
};

}  // namespace moat
