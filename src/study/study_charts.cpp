#include "study/study_charts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "base/check.hpp"
#include "output/files/engineering_unit.hpp"
#include "study/responses.hpp"

namespace moat {
namespace {

constexpr std::size_t most_curves = 7, fewest_values = 3;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<std::size_t> numeric_axes(const StudyResult& study) {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < study.axes().size(); ++i)
    if (study.axes()[i].labels.empty() && study.axes()[i].values.size() >= fewest_values) list.push_back(i);
  return list;
}

std::string label_of(const StudyAxis& axis) { return axis.name + (axis.unit.empty() ? "" : " [" + axis.unit + "]"); }

using Curves = std::map<std::string, std::map<double, double>>;  // by the other axes, by the value on this one

Curves curves_over(const StudyResult& study, std::size_t axis, const std::vector<double>& values) {
  Curves curves;
  for (std::size_t number = 0; number < values.size(); ++number) {
    if (std::isnan(values[number])) continue;
    std::string others;
    const StudyCase each{study.cases(), number};
    for (std::size_t i = 0; i < study.axes().size(); ++i) {
      if (i == axis || study.cases().groups()[i] == study.cases().groups()[axis]) continue;
      const StudyAxis& other = study.axes()[i];
      others += (others.empty() ? "" : ", ") + (other.labels.empty() ? other.name + " " : "") + each.label(other.name) +
                (other.labels.empty() && !other.unit.empty() ? " " + other.unit : "");
    }
    curves[others][study.axes()[axis].values[study.cases().position(axis, number)]] = values[number];
  }
  return curves;
}

void add_finite(Series& series, double x, double y) {
  if (!std::isfinite(y)) return;
  series.x.push_back(x);
  series.y.push_back(y);
}

void add_median(Chart& chart, const Curves& curves) {
  constexpr double low = 0.16, high = 0.84;
  std::map<double, std::vector<double>> at;
  for (const auto& [others, curve] : curves)
    for (const auto& [x, y] : curve) at[x].push_back(y);
  Series band{.name = "16 to 84 %", .x = {}, .y = {}, .style = Series::Style::band, .colour = 0};
  Series median{.name = "median of " + std::to_string(curves.size()), .x = {}, .y = {}, .colour = 0};
  for (const auto& [x, values] : at) {
    add_finite(median, x, fractile(values, 0.5));
    add_finite(band, x, fractile(values, high));
  }
  // Back along the levels that the upper end has.
  for (std::size_t i = band.x.size(); i-- > 0;) add_finite(band, band.x[i], fractile(at[band.x[i]], low));
  chart.series = {std::move(band), std::move(median)};
}

}  // namespace

double fractile(std::vector<double> values, double share) {
  if (values.empty()) return nan;
  std::ranges::sort(values);
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double share_of_next = place - static_cast<double>(below);
  if (share_of_next <= 0.0 || std::isinf(values[below])) return values[below];
  return values[below] + share_of_next * (values[below + 1] - values[below]);
}

std::vector<Chart> axis_charts(const StudyResult& study) {
  std::vector<Chart> charts;
  for (const std::size_t axis : numeric_axes(study))
    for (const StudyResponse& response : responses_of(study)) {
      const Curves curves = curves_over(study, axis, response.values);
      if (curves.empty()) continue;
      Chart chart{
          .title = response.title, .x_label = label_of(study.axes()[axis]), .y_label = response.label, .series = {}};
      if (curves.size() > most_curves) {
        add_median(chart, curves);
      } else {
        for (const auto& [others, curve] : curves) {
          Series series{.name = others, .x = {}, .y = {}};
          for (const auto& [x, y] : curve) add_finite(series, x, y);
          chart.series.push_back(std::move(series));
        }
      }
      std::erase_if(chart.series, [](const Series& each) { return each.x.empty(); });
      if (!chart.series.empty()) charts.push_back(std::move(chart));
    }
  return charts;
}

std::vector<HeatMap> heat_maps(const StudyResult& study) {
  const std::vector<std::size_t> axes = numeric_axes(study);
  if (axes.size() != 2 || study.cases().groups()[axes[0]] == study.cases().groups()[axes[1]]) return {};
  const StudyAxis &x = study.axes()[axes[0]], &y = study.axes()[axes[1]];
  std::vector<HeatMap> maps;
  for (const StudyResponse& response : responses_of(study)) {
    std::vector cells(y.values.size(), std::vector<std::vector<double>>(x.values.size()));
    for (std::size_t number = 0; number < response.values.size(); ++number) {
      if (std::isnan(response.values[number])) continue;
      cells[study.cases().position(axes[1], number)][study.cases().position(axes[0], number)].push_back(
          response.values[number]);
    }
    bool any = false;
    HeatMap map{.title = response.title,
                .x_label = label_of(x),
                .y_label = label_of(y),
                .value_label = response.label,
                .x_values = {},
                .y_values = {},
                .values = {}};
    for (const double value : x.values) map.x_values.push_back(to_text(value));
    for (const double value : y.values) map.y_values.push_back(to_text(value));
    for (const auto& row : cells) {
      map.values.emplace_back();
      for (const auto& cell : row) {
        const double median = fractile(cell, 0.5);
        any = any || std::isfinite(median);
        map.values.back().push_back(std::isfinite(median) ? median : nan);
      }
    }
    if (any) maps.push_back(std::move(map));
  }
  return maps;
}

}  // namespace moat
