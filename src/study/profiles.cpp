#include "study/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "report/charts/result_charts.hpp"
#include "study/statistics.hpp"

namespace moat {
namespace {

// The curves of all records in one combination of the other axes.
struct Profiles {
  std::vector<Series> records{}, fallen{};
  std::size_t unsolved = 0;

  [[nodiscard]] std::size_t count() const { return records.size() + fallen.size(); }
  [[nodiscard]] const std::vector<Series>& drawn() const { return records.empty() ? fallen : records; }

  // Returns a curve of one statistic of the values at every level; it has no points where a collapse makes it infinite.
  [[nodiscard]] Series curve(std::string name, double Statistics::*which) const {
    Series curve{.name = std::move(name), .y = drawn().front().y, .colour = 1};
    for (std::size_t level = 0; level < curve.y.size(); ++level) {
      std::vector<double> values(fallen.size(), std::numeric_limits<double>::infinity());
      for (const Series& each : records) values.push_back(each.x[level]);
      curve.x.push_back(statistics_of(values).*which);
    }
    if (!std::ranges::all_of(curve.x, [](double each) { return std::isfinite(each); })) curve.x = curve.y = {};
    return curve;
  }
  // Profiles with a larger rank govern.
  [[nodiscard]] std::pair<std::size_t, double> rank() const {
    if (records.empty()) return {fallen.size(), 0.0};
    return {fallen.size(), std::ranges::max(Profiles{records}.curve("", &Statistics::mean).x)};
  }

  // "records, 1 of 7 collapsed: mean infinite, 2 without result"
  [[nodiscard]] std::string legend() const {
    std::string text = "records";
    if (!fallen.empty())
      text += ", " + std::to_string(fallen.size()) + " of " + std::to_string(count()) + " collapsed: mean infinite";
    if (unsolved > 0) text += ", " + std::to_string(unsolved) + " without result";
    return text;
  }
};

bool has_fallen(const CaseOutcome& outcome) {
  return std::ranges::any_of(outcome.results,
                             [](const NamedNumber& each) { return each.quantity == "collapsed" && each.value > 0.0; });
}

// Adds the curves of a combination to a chart without any.
void add_curves(Chart& chart, const Profiles& profiles) {
  double farthest = 0.0;
  for (const Series& each : profiles.drawn()) {
    chart.series.push_back(
        {.name = chart.series.empty() ? profiles.legend() : "", .x = each.x, .y = each.y, .colour = 4});
    farthest = std::max(farthest, std::ranges::max(each.x));
  }
  if (farthest > 0.0) chart.x_range = std::pair{0.0, 1.05 * farthest};
  const std::string of = " of " + std::to_string(profiles.count()) + " records";
  Series middle = profiles.fallen.empty() ? profiles.curve("mean" + of, &Statistics::mean)
                                          : profiles.curve("median" + of, &Statistics::median);
  Series upper = profiles.curve("84 %", &Statistics::fractile_84);
  upper.style = Series::Style::dashed;
  for (Series* each : {&middle, &upper})
    if (!each->x.empty()) chart.series.push_back(std::move(*each));
}

}  // namespace

std::vector<Chart> profiles_over_records(const StudyResult& study, CaseResult like) {
  const std::string axis = axis_of_records(study);
  if (axis.empty() || study.axes()[study.cases().index_of(axis)].values.size() < 2) return {};
  using Place = std::pair<std::string, std::string>;  // title and building
  std::vector<Chart> charts;                          // without curves
  // The group that governs each place; the curves of all groups would need more memory than the results.
  std::map<Place, std::pair<std::string, Profiles>> governing;
  for (const auto& [group, numbers] : groups_over(study, axis)) {
    std::map<Place, Profiles> of_group;
    std::size_t unsolved = 0;
    for (const std::size_t number : numbers) {
      const CaseOutcome outcome = study.outcome(number);
      if (outcome.state != CaseState::done) ++unsolved;
      like.peaks.clear();
      for (const NamedNumber& each : outcome.results)
        like.peaks.push_back({each.quantity, each.where, each.value, each.unit});
      for (Chart& chart : floor_profiles(like)) {
        for (Series& series : chart.series) {
          Profiles& profiles = of_group[{chart.title, series.name}];
          (has_fallen(outcome) ? profiles.fallen : profiles.records).push_back(std::move(series));
        }
        chart.series.clear();
        chart.x_range.reset();
        if (std::ranges::find(charts, chart.title, &Chart::title) == charts.end()) charts.push_back(std::move(chart));
      }
    }
    for (auto& [place, profiles] : of_group) {
      if (profiles.count() < 2) continue;
      profiles.unsolved = unsolved;
      const auto [known, is_first] = governing.try_emplace(place);
      if (is_first || profiles.rank() > known->second.second.rank()) known->second = {group, std::move(profiles)};
    }
  }
  std::vector<Chart> filled;
  for (const Chart& chart : charts)
    for (const auto& [place, of_group] : governing) {
      if (place.first != chart.title) continue;
      const auto& [group, profiles] = of_group;
      Chart& shown = filled.emplace_back(chart);
      if (!place.second.empty()) shown.title += ", " + place.second;
      if (!group.empty()) shown.title += ", " + group;
      add_curves(shown, profiles);
    }
  return filled;
}

}  // namespace moat
