// Exact steps while no gap is closed, by request or by choice of the analysis.
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

/// ExactBetweenEvents where it applies to a model of at most 16 degrees of freedom, else Newmark. The choice and its
/// reason are among the assumptions of the results.
///
/// Exact steps of such models are faster. For larger models they are slower, because their matrices are full.
struct Automatic {
  static constexpr std::string_view name = "automatic";
  static constexpr int most_degrees_of_freedom = 16;  ///< Limit of exact steps; Newmark's method solves larger models.

  /// Returns the methods between which every step chooses.
  [[nodiscard]] StepMethods methods(AnalysisState& state, const StepSettings& settings) const;
  void check(const Check&) const {}
  [[nodiscard]] std::string description() const { return "Exact between events, or Newmark's method"; }

  friend bool operator==(const Automatic&, const Automatic&) = default;
};

}  // namespace moat
