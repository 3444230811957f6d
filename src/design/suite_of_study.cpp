#include "design/suite_of_study.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "base/check.hpp"
#include "study/statistics.hpp"

namespace moat {
namespace {

// The largest design value of these quantities, at one place or at all; 0 where there is none.
double largest_of(const std::vector<RecordStatistics>& list, const std::string& bound,
                  std::initializer_list<std::string_view> quantities, std::string_view where) {
  double largest = 0.0;
  for (const RecordStatistics& each : list)
    if (!each.envelope && each.group.find(bound) != std::string::npos && (where.empty() || each.where == where) &&
        std::ranges::find(quantities, each.quantity) != quantities.end())
      largest = std::max(largest, each.design_value());
  return largest;
}

}  // namespace

SuiteForSheet suite_for_sheet(const StudyResult& study, const std::string& base) {
  const Check check{"suite_for_sheet", ""};
  const std::string axis = axis_of_records(study);
  check.that(!axis.empty(), "the study has no axis of records.", "Use a suite, or an axis of record_axis().");
  const std::vector<RecordStatistics> list = statistics_over(study, axis);
  const std::size_t records = study.axes()[study.cases().index_of(axis)].values.size();
  std::size_t solved = records;
  for (const RecordStatistics& each : list)
    if (!each.envelope && each.quantity == "displacement" && each.where == base) solved = std::min(solved, each.solved);
  SuiteForSheet suite{.statistic = (solved >= fewest_for_mean ? "mean of " : "largest of ") + std::to_string(solved) +
                                   (solved < records ? " of " + std::to_string(records) : "") + " records"};
  const bool has_bounds =
      std::ranges::any_of(study.axes(), [](const StudyAxis& each) { return each.name == "bounds"; });
  const auto values_of = [&](const std::string& bound) {
    constexpr double percent = 0.01;
    return SuiteValues{
        .displacement = largest_of(list, bound, {"displacement"}, base) * units::m,
        .corner_displacement = largest_of(list, bound, {"corner_displacement"}, base) * units::m,
        .base_shear =
            largest_of(list, bound, {"total_base_shear", "total_base_shear_x", "total_base_shear_y"}, "") * units::N,
        .storey_shear = largest_of(list, bound, {"storey_shear", "storey_shear_x", "storey_shear_y"}, "") * units::N,
        .drift = percent * largest_of(list, bound, {"drift_ratio", "corner_drift_ratio"}, "")};
  };
  suite.nominal = values_of(has_bounds ? "bounds = nominal" : "");
  if (has_bounds) {
    suite.lower = values_of("bounds = lower");
    suite.upper = values_of("bounds = upper");
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

}  // namespace moat
