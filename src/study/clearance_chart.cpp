#include "study/clearance_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "study/statistics.hpp"

namespace moat {
namespace {

struct Clearances {
  std::vector<double> left{};  // cm, of the solved cases
  std::size_t unsolved = 0;
};

Series distribution_of(const std::string& bound, Clearances of) {
  std::ranges::sort(of.left);
  const auto count = static_cast<double>(of.left.size());
  Series series{.name = (bound.empty() ? "" : bound + ", ") + std::to_string(of.left.size()) + " cases" +
                        (of.unsolved > 0 ? ", " + std::to_string(of.unsolved) + " without result" : "")};
  for (std::size_t i = 0; i < of.left.size(); ++i)
    for (const std::size_t below : {i, i + 1}) {
      series.x.push_back(of.left[i]);
      series.y.push_back(static_cast<double>(below) / count);
    }
  return series;
}

}  // namespace

std::optional<Chart> clearance_chart(const StudyResult& study) {
  const std::string records = axis_of_records(study);
  if (records.empty() || study.axes()[study.cases().index_of(records)].values.size() < 2) return {};
  if (std::ranges::any_of(study.axes(),
                          [](const StudyAxis& axis) { return axis.labels.empty() && axis.name != "direction"; }))
    return {};
  const auto bounds = std::ranges::find(study.axes(), "bounds", &StudyAxis::name);
  std::map<std::size_t, Clearances> by_bound;
  for (std::size_t number = 0; number < study.cases().count(); ++number) {
    const StudyCase each{study.cases(), number};
    Clearances& of = by_bound[bounds == study.axes().end() ? 0 : each.position(bounds->name)];
    const CaseOutcome outcome = study.outcome(number);
    if (outcome.state != CaseState::done) ++of.unsolved;
    double smallest = std::numeric_limits<double>::infinity();
    for (const NamedNumber& result : outcome.results)
      if (result.quantity == "clearance_left") smallest = std::min(smallest, result.value);
    if (std::isfinite(smallest)) of.left.push_back(Length{smallest} / units::cm);
  }
  Chart chart{.title = "Clearance left",
              .x_label = "smallest clearance left [cm]",
              .y_label = "share of the cases",
              .y_from_zero = true};
  for (const auto& [position, of] : by_bound)
    if (!of.left.empty())
      chart.series.push_back(distribution_of(bounds == study.axes().end() ? "" : bounds->labels[position], of));
  if (chart.series.empty()) return {};
  return chart;
}

}  // namespace moat
