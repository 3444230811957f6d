#include "study/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <utility>

#include "report/charts/chart_columns.hpp"
#include "report/charts/result_charts.hpp"
#include "study/statistics.hpp"

namespace moat {
namespace {

// The curves of all records in one combination of the other axes.
struct Profiles {
  std::vector<Series> records{};
  std::size_t collapsed = 0;

  // A curve of one statistic of the values at every level.
  [[nodiscard]] Series curve(std::string name, double Statistics::*which) const {
    Series curve{.name = std::move(name), .y = records.front().y, .colour = 1};
    for (std::size_t level = 0; level < curve.y.size(); ++level) {
      std::vector<double> values;
      for (const Series& each : records) values.push_back(each.x[level]);
      curve.x.push_back(statistics_of(values).*which);
    }
    return curve;
  }
};

bool has_fallen(const CaseOutcome& outcome) {
  return std::ranges::any_of(outcome.results,
                             [](const NamedNumber& each) { return each.quantity == "collapsed" && each.value > 0.0; });
}

}  // namespace

std::vector<Chart> profiles_over_records(const StudyResult& study, CaseResult like) {
  const std::string axis = axis_of_records(study);
  if (axis.empty() || study.axes()[study.cases().index_of(axis)].values.size() < 2) return {};
  std::vector<Chart> charts;                                                           // without curves
  std::map<std::pair<std::string, std::string>, std::map<std::string, Profiles>> all;  // by title and building, group
  for (const auto& [group, numbers] : groups_over(study, axis))
    for (const std::size_t number : numbers) {
      const CaseOutcome& outcome = study.outcomes()[number];
      like.peaks.clear();
      for (const NamedNumber& each : outcome.results)
        like.peaks.push_back({each.quantity, each.where, each.value, each.unit});
      for (Chart& chart : floor_profiles(like)) {
        for (Series& series : chart.series) {
          Profiles& profiles = all[{chart.title, series.name}][group];
          if (has_fallen(outcome))
            ++profiles.collapsed;
          else
            profiles.records.push_back(std::move(series));
        }
        chart.series.clear();
        chart.x_range.reset();
        if (std::ranges::find(charts, chart.title, &Chart::title) == charts.end()) charts.push_back(std::move(chart));
      }
    }
  std::vector<Chart> filled;
  for (const Chart& chart : charts)
    for (const auto& [key, groups] : all) {
      if (key.first != chart.title) continue;
      const Profiles* governing = nullptr;
      std::string group;
      double largest = 0.0;
      for (const auto& [name, profiles] : groups) {
        if (profiles.records.size() < 2) continue;
        const double top = std::ranges::max(profiles.curve("", &Statistics::mean).x);
        if (governing != nullptr && top <= largest) continue;
        governing = &profiles;
        group = name;
        largest = top;
      }
      if (governing == nullptr) continue;
      Chart& shown = filled.emplace_back(chart);
      if (!key.second.empty()) shown.title += ", " + key.second;
      if (!group.empty()) shown.title += ", " + group;
      double farthest = 0.0;
      for (const Series& each : governing->records) {
        shown.series.push_back({.name = shown.series.empty() ? "records" : "", .x = each.x, .y = each.y, .colour = 4});
        farthest = std::max(farthest, std::ranges::max(each.x));
      }
      if (farthest > 0.0) shown.x_range = std::pair{0.0, 1.05 * farthest};
      const std::string left_out =
          governing->collapsed > 0 ? ", without " + std::to_string(governing->collapsed) + " that collapsed" : "";
      shown.series.push_back(governing->curve(
          "mean of " + std::to_string(governing->records.size()) + " records" + left_out, &Statistics::mean));
      Series upper = governing->curve("84 %", &Statistics::fractile_84);
      upper.style = Series::Style::dashed;
      shown.series.push_back(std::move(upper));
    }
  return filled;
}

std::vector<Chart> floor_spectra_over_records(const StudyResult& study) {
  const std::string axis = axis_of_records(study);
  if (axis.empty()) return {};
  const std::vector<RecordStatistics> all = statistics_over(study, axis);
  const bool has_envelope = std::ranges::any_of(all, &RecordStatistics::envelope);
  std::vector<Chart> charts;
  for (const RecordStatistics& each : all) {
    if (each.quantity != "floor_sa" || each.envelope != has_envelope) continue;
    // "roof, x, 5 %, 0.3 s"
    const std::size_t comma = each.where.rfind(", ");
    const std::string title = "Floor spectrum, " + each.where.substr(0, comma);
    if (charts.empty() || charts.back().title != title)
      charts.push_back({.title = title,
                        .x_label = "period of an oscillator [s]",
                        .y_label = axis_label("pseudo-acceleration", each.unit),
                        .series = {{.name = "largest", .colour = 4},
                                   {.name = "mean", .colour = 1},
                                   {.name = "84 %", .style = Series::Style::dashed, .colour = 1}},
                        .logarithmic_x = true,
                        .y_from_zero = true,
                        .second_unit = second_scale(each.unit)});
    const double period = std::strtod(each.where.c_str() + comma + 2, nullptr);
    const double values[] = {each.statistics.largest, each.statistics.mean, each.statistics.fractile_84};
    for (std::size_t i = 0; i < std::size(values); ++i) {
      if (!std::isfinite(values[i])) continue;
      charts.back().series[i].x.push_back(period);
      charts.back().series[i].y.push_back(values[i]);
    }
  }
  for (Chart& chart : charts) std::erase_if(chart.series, [](const Series& each) { return each.x.empty(); });
  std::erase_if(charts, [](const Chart& chart) { return chart.series.empty(); });
  return charts;
}

}  // namespace moat
