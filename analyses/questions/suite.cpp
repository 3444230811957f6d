#include "analyses/questions/suite.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "base/check.hpp"
#include "base/text/number_format.hpp"

namespace moat {
namespace {

constexpr const char *of_record = "record", *of_bounds = "bounds", *of_eccentricity = "eccentricity",
                     *of_direction = "direction";
constexpr std::array<PlanVector, 5> shifts{{{0.0, 0.0}, {1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}};

}  // namespace

SuiteRecords::SuiteRecords(ScaledSuite scaled) : scaled_{std::move(scaled)} {
  for (const NamedPair& pair : scaled_->pairs) pairs_.push_back(pair.motion);
  axis_ = record_axis(of_record, pairs_);
  for (std::size_t i = 0; i < axis_.labels.size(); ++i) axis_.labels[i] = scaled_->pairs[i].name;
}

SuiteRecords::SuiteRecords(std::vector<GroundMotion> motions)
    : motions_{std::move(motions)}, axis_{record_axis(of_record, motions_)} {}

SuiteRecords::SuiteRecords(std::vector<PlanMotion> pairs)
    : pairs_{std::move(pairs)}, axis_{record_axis(of_record, pairs_)} {}

GroundMotion SuiteRecords::motion(std::size_t record, Angle turned_by) const {
  return are_pairs() ? pairs_[record].rotated(turned_by).resolved() : motions_[record];
}

Suite::Suite(SuiteRecords records, SuiteOptions options) : records_{std::move(records)}, options_{std::move(options)} {
  const Check check{"Suite", ""};
  check.that(!records_.axis().values.empty(), "there are no records.", "Give at least one.");
  check.that(options_.eccentricity >= 0.0 && options_.eccentricity < 0.5, "eccentricity", options_.eccentricity, "1",
             ">= 0 and < 0.5", "5 % is 0.05.");
  check.that(records_.are_pairs() || options_.directions.empty(), "directions are given of motions on a line.",
             "Give pairs of components.");
  if (options_.bounds) check_factors(*options_.bounds);
  static_cast<void>(cases());
}

StudyCases Suite::cases() const {
  std::vector<StudyAxis> axes{records_.axis()};
  if (options_.bounds) axes.push_back(StudyAxis::of_names(of_bounds, {"lower", "nominal", "upper"}));
  if (options_.eccentricity > 0.0)
    axes.push_back(StudyAxis::of_names(of_eccentricity, {"none", "+x", "-x", "+y", "-y"}));
  if (!options_.directions.empty()) {
    StudyAxis axis{.name = of_direction, .unit = "deg", .values = {}};
    for (const Angle direction : options_.directions) axis.values.push_back(direction / units::deg);
    axes.push_back(std::move(axis));
  }
  return axes;
}

StudyModel Suite::model(const StudyCase& each, const std::function<Model(const SuiteCase&)>& make) const {
  SuiteCase of;
  if (options_.bounds)
    of.factors =
        std::array{options_.bounds->lower, PropertyFactors{}, options_.bounds->upper}[each.position(of_bounds)];
  if (options_.eccentricity > 0.0) of.eccentricity = options_.eccentricity * shifts[each.position(of_eccentricity)];
  const Angle turned_by = options_.directions.empty() ? Angle{} : options_.directions[each.position(of_direction)];
  return {make(of), records_.motion(each.position(of_record), turned_by)};
}

StudyResult run_suite(const Suite& suite, const std::function<Model(const SuiteCase&)>& make) {
  const std::function<StudyModel(const StudyCase&)> model = [&](const StudyCase& each) {
    return suite.model(each, make);
  };
  return run_study(suite.cases(), model, suite.study());
}

std::vector<std::size_t> cases_with_largest_deformation(const StudyResult& suite) {
  const bool has_bounds = std::ranges::find(suite.axes(), of_bounds, &StudyAxis::name) != suite.axes().end();
  std::map<std::size_t, std::pair<double, std::size_t>> largest;  // by bound: deformation and case
  for (std::size_t number = 0; number < suite.cases().count(); ++number) {
    double deformation = 0.0;
    bool collapsed = false;
    const CaseOutcome outcome = suite.outcome(number);
    for (const NamedNumber& each : outcome.results) {
      if (each.quantity == "isolator_deformation") deformation = std::max(deformation, each.value);
      if (each.quantity == "collapsed" && each.value > 0.0) collapsed = true;
    }
    if (collapsed || !(deformation > 0.0)) continue;
    auto& [value, of_case] = largest[has_bounds ? StudyCase{suite.cases(), number}.position(of_bounds) : 0];
    if (deformation > value) std::tie(value, of_case) = std::pair{deformation, number};
  }
  std::vector<std::size_t> numbers;
  for (const auto& [bound, found] : largest) numbers.push_back(found.second);
  return numbers;
}

}  // namespace moat
