// Suites: every record with every bound of the isolators, every accidental eccentricity and every direction.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyses/questions/property_bounds.hpp"
#include "analyses/questions/study.hpp"
#include "base/plan_vector.hpp"
#include "motions/plan_motion.hpp"
#include "motions/spectra/scale_suite.hpp"

namespace moat {

/// One case of a suite, for the function that makes its model.
struct SuiteCase {
  PropertyFactors factors{};  ///< Factors of the isolators: those of the bound, or 1.
  PlanVector eccentricity{};  ///< Shares of the extent along x and y that centres of mass are moved by.
};

/// Properties, eccentricities and directions that are combined with the records.
struct SuiteOptions {
  /// Lower, nominal and upper properties of the isolators; nominal ones alone if left out.
  std::optional<PropertyBounds> bounds{};
  /// >= 0, < 0.5: share of the extent. Five cases where it is > 0: none, +x, -x, +y, -y (ASCE/SEI 7, recalled: 5 %).
  double eccentricity = 0.0;
  /// Added to the incidence of pairs, > -360 deg, < 360 deg; the pair as it is if left out.
  std::vector<Angle> directions{};
  StudyOptions study{};  ///< How cases are computed.
};

/// Records of a suite: motions on a line, or pairs in plan, with names that differ.
class SuiteRecords {
 public:
  SuiteRecords(ScaledSuite scaled);  ///< Pairs that are scaled to a target spectrum, by their names there.
  SuiteRecords(std::vector<GroundMotion> motions);  ///< For models on a line.
  SuiteRecords(std::vector<PlanMotion> pairs);      ///< For models in plan.

  [[nodiscard]] bool are_pairs() const { return !pairs_.empty(); }  ///< Whether they have two components.
  [[nodiscard]] const StudyAxis& axis() const { return axis_; }     ///< Named "record".
  /// The motion of a record, a pair turned by this angle.
  [[nodiscard]] GroundMotion motion(std::size_t record, Angle turned_by) const;

  /// Returns the scaled suite that was given; none for motions that were scaled otherwise.
  [[nodiscard]] const std::optional<ScaledSuite>& scaled() const { return scaled_; }

 private:
  std::vector<GroundMotion> motions_;
  std::vector<PlanMotion> pairs_;
  std::optional<ScaledSuite> scaled_{};
  StudyAxis axis_;  // hashes take time
};

/// The cases of a suite: axes "record", "bounds", "eccentricity" and "direction", of which those with one value are
/// left out.
class Suite {
 public:
  /// Throws InputError for no record, names that are equal, bounds or shares outside their range, and directions of
  /// motions on a line.
  Suite(SuiteRecords records, SuiteOptions options);

  [[nodiscard]] StudyCases cases() const;  ///< In the order of the axes, the last one fastest.
  /// Makes the model of a case under its motion.
  [[nodiscard]] StudyModel model(const StudyCase& each, const std::function<Model(const SuiteCase&)>& make) const;
  [[nodiscard]] const StudyOptions& study() const { return options_.study; }  ///< The options as given.
  [[nodiscard]] const SuiteRecords& records() const { return records_; }      ///< The records as given.

 private:
  SuiteRecords records_;
  SuiteOptions options_;
};

/// Computes a suite: run_study() of its cases. Statistics over its records: statistics_over() (study/statistics.hpp).
///
///     const StudyResult result = run_suite({pairs, {.bounds = bounds, .eccentricity = 0.05}}, [&](const SuiteCase&
///     each) {
///       Model model;
///       const auto tower = add(model, with_eccentricity(building_with(each.factors), each.eccentricity.x,
///                                                       each.eccentricity.y));
///       add(model, PlanMoat{.around = tower.base, ...});
///       return model;
///     });
StudyResult run_suite(const Suite& suite, const std::function<Model(const SuiteCase&)>& make);

/// The case with the largest deformation of an isolator for each bound, or of all cases where there are no bounds; of
/// cases that collapsed or have no result none. Empty for models without isolators.
[[nodiscard]] std::vector<std::size_t> cases_with_largest_deformation(const StudyResult& suite);

}  // namespace moat
