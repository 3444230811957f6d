// Upper and lower bounds of isolator properties.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "analyses/case/case_run.hpp"

namespace moat {

/// Factors on the nominal properties of isolators: on strength or friction, and on the stiffness after yield.
struct PropertyFactors {
  double strength = 1.0;   ///< Factor of the characteristic strength, > 0.
  double stiffness = 1.0;  ///< Factor of the post-yield stiffness, > 0.
};

/// Bounds of isolator properties, by ageing, temperature, contamination, first cycles and manufacture. The factors
/// belong to the maker's tests and to the code: there are no defaults.
struct PropertyBounds {
  /// > 0, <= 1.
  PropertyFactors lower;
  /// >= 1.
  PropertyFactors upper;

  /// lambda_max = [1 + 0.75 (lambda_ae,max - 1)] lambda_test,max lambda_spec,max and lambda_min likewise, at least 1.8
  /// and at most 0.6 unless the isolators are qualified by tests. Source: ASCE/SEI 7-16, chapter 17 (recalled, not read
  /// in the code).
  struct Lambda {
    /// Factors for ageing and environment, for heating and cycles, for scatter of production.
    double ageing = 1.0, test = 1.0, specification = 1.0;
  };
  /// The upper factor of strength or stiffness, >= 1.8 unless qualified by tests.
  static double asce_7_upper(const Lambda& lambda, bool qualified_by_tests = true);
  /// The lower factor of strength or stiffness, <= 0.6 unless qualified by tests.
  static double asce_7_lower(const Lambda& lambda, bool qualified_by_tests = true);
};

/// Throws InputError for factors outside their range.
void check_factors(const PropertyBounds& bounds);

/// The three cases in the order nominal, lower, upper, and the envelope of their peaks.
struct BoundedResult {
  std::array<CaseResult, 3> cases;  ///< Results in the order of `names`.
  static constexpr std::array<const char*, 3> names{"nominal", "lower bound", "upper bound"};  ///< Names of the cases.

  /// The largest of the three for every peak, with the case that governs. Pounding is not monotone in these factors:
  /// the lower bound gives most displacements and the upper most forces, but either may govern.
  struct Governing {
    Peak peak;       ///< The largest of the three cases.
    std::string of;  ///< one of `names`
  };
  std::vector<Governing> envelope;  ///< One for every peak.

  /// Magnitude of the envelope. Throws InputError where no case has such a peak.
  [[nodiscard]] const Governing& governing(const std::string& quantity, const std::string& where) const;
};

/// Runs nominal, lower and upper properties. `model_with` makes the model with these factors, the same parts in each:
///
///     run_bounds({.lower = {0.8, 0.9}, .upper = {1.3, 1.2}}, [&](const PropertyFactors& factors) { ... }, motion);
///
/// Throws InputError for factors outside their range, and as run_case does.
BoundedResult run_bounds(const PropertyBounds& bounds, const std::function<Model(const PropertyFactors&)>& model_with,
                         const GroundMotion& motion, const CaseOptions& options = {});

}  // namespace moat
