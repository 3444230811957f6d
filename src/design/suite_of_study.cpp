#include "design/suite_of_study.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "study/statistics.hpp"

namespace moat {
namespace {

constexpr const char* bounds_axis = "bounds";

/// The design values of a study in the groups of one bound; of all groups where there are no bounds.
class DesignValues {
 public:
  DesignValues(const StudyResult& study, const std::string& axis, const std::string& bound,
               const std::vector<RecordStatistics>& all)
      : all_{all} {
    const std::size_t records = study.cases().index_of(axis);
    const std::vector<double> impacts = has(study, "impacts") ? study.values("impacts", "") : std::vector<double>{};
    std::set<std::size_t> touching;
    for (const auto& [group, cases] : groups_over(study, axis)) {
      if (!bound.empty() && StudyCase{study.cases(), cases.front()}.label(bounds_axis) != bound) continue;
      groups_.insert(group);
      for (const std::size_t number : cases)
        if (!impacts.empty() && impacts[number] > 0.0) touching.insert(study.cases().position(records, number));
    }
    touching_ = touching.size();
  }

  static bool has(const StudyResult& study, std::string_view quantity) {
    return std::ranges::find(study.table().columns, quantity, &Column::quantity) != study.table().columns.end();
  }

  /// The largest over the groups, at one place or at all; none without a value.
  [[nodiscard]] std::optional<double> largest(std::string_view quantity, std::string_view where = {}) const {
    std::optional<double> largest;
    for (const RecordStatistics& each : all_)
      if (!each.envelope && each.quantity == quantity && (where.empty() || each.where == where) &&
          groups_.contains(each.group))
        largest = std::max(largest.value_or(0.0), each.design);
    return largest;
  }
  /// On a line as largest(), in plan the smaller of its components.
  [[nodiscard]] std::optional<double> smaller_component(const std::string& quantity, std::string_view where) const {
    const std::optional<double> x = largest(quantity + "_x", where), y = largest(quantity + "_y", where);
    return x && y ? std::min(*x, *y) : largest(quantity, where);
  }
  [[nodiscard]] std::size_t touching() const { return touching_; }

 private:
  const std::vector<RecordStatistics>& all_;
  std::set<std::string> groups_;
  std::size_t touching_ = 0;
};

// "west base" has "west storey 1".
std::string first_storey_on(const std::string& base) {
  constexpr std::string_view suffix = " base";
  return (base.ends_with(suffix) ? base.substr(0, base.size() - suffix.size()) + " " : "") + "storey 1";
}

}  // namespace

SuiteForSheet suite_for_sheet(const StudyResult& study, const std::string& base) {
  const Check check{"suite_for_sheet", ""};
  const std::string axis = axis_of_records(study);
  check.that(!axis.empty(), "the study has no axis of records.", "Use a suite, or an axis of record_axis().");
  const std::size_t records = study.axes()[study.cases().index_of(axis)].values.size();
  std::size_t solved = records;
  const std::vector<RecordStatistics> all = statistics_over(study, axis);
  for (const RecordStatistics& each : all) {
    if (each.envelope || each.quantity != "displacement" || each.where != base) continue;
    check.that(each.solved > 0, "no record has a result with " + each.group + ".", "Compute its cases again.");
    solved = std::min(solved, each.solved);
  }
  SuiteForSheet suite{.statistic = (solved >= fewest_for_mean ? "mean of " : "largest of ") + std::to_string(solved) +
                                   (solved < records ? " of " + std::to_string(records) : "") + " records"};
  const bool has_bounds = std::ranges::find(study.axes(), bounds_axis, &StudyAxis::name) != study.axes().end();
  const auto values_of = [&](const std::string& bound) {
    constexpr double percent = 0.01;
    const DesignValues of{study, axis, bound, all};
    // A building without a name lists them at "base", also where its base has another name.
    const auto total = [&](const std::string& quantity) {
      const std::optional<double> here = of.smaller_component(quantity, base);
      return here ? here : of.smaller_component(quantity, "base");
    };
    const std::optional<double> isolators = total("total_isolator_force");
    suite.base_shear_has_impacts = suite.base_shear_has_impacts || !isolators;
    return SuiteValues{
        .displacement = of.largest("displacement", base).value_or(0.0) * units::m,
        .corner_displacement = of.largest("corner_displacement", base).value_or(0.0) * units::m,
        .base_shear = (isolators ? isolators : total("total_base_shear")).value_or(0.0) * units::N,
        .storey_shear = of.smaller_component("storey_shear", first_storey_on(base)).value_or(0.0) * units::N,
        .drift =
            percent * std::max(of.largest("drift_ratio").value_or(0.0), of.largest("corner_drift_ratio").value_or(0.0)),
        .touching = of.touching()};
  };
  suite.nominal = values_of(has_bounds ? "nominal" : "");
  if (has_bounds) {
    suite.lower = values_of("lower");
    suite.upper = values_of("upper");
  }
  // Nothing is kept by a record that collapsed, nor by a bound without results.
  const auto has_value = [&](const SuiteValues& of, const char* bound) {
    const double displacement = of.displacement.si();
    check.that(displacement > 0.0, std::string{"no case"} + bound + " has a displacement of \"" + base + "\".",
               "Give the name of the base, or compute its cases again.");
    check.that(std::isfinite(displacement),
               std::string{"records"} + bound + " collapsed, so that there is no design value.",
               "Change the design, or give the sheet without a suite.");
  };
  has_value(suite.nominal, has_bounds ? " of nominal properties" : "");
  if (!has_bounds) return suite;
  has_value(suite.lower, " of lower bounds");
  has_value(suite.upper, " of upper bounds");
  return suite;
}

SuiteForSheet suite_for_sheet(const StudyResult& study, const ScaledSuite& scaled, const std::string& base) {
  SuiteForSheet suite = suite_for_sheet(study, base);
  suite.scaling = scaled.description();
  return suite;
}

}  // namespace moat
