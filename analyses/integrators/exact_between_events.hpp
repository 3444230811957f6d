// Exact steps while no gap is closed.
#pragma once

#include <string>
#include <string_view>

#include "analyses/time_history/step_method.hpp"
#include "base/check.hpp"

namespace moat {

/// Exact steps while no gap is closed (analyses/integrators/exact_method.hpp), Newmark's method in contact: for small
/// models whose springs, dampers and bearings are linear between located events.
struct ExactBetweenEvents {
  static constexpr std::string_view name = "exact-between-events";

  /// Throws InputError where the model is not linear between events (ExactMethod).
  [[nodiscard]] StepMethods methods(AnalysisState& state, const StepSettings& settings) const;
  void check(const Check&) const {}
  [[nodiscard]] std::string description() const {
    return "Exact steps while no gap is closed; in contact: Newmark's method";
  }

  friend bool operator==(const ExactBetweenEvents&, const ExactBetweenEvents&) = default;
};

}  // namespace moat
