#include "report/charts/result_charts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "base/check.hpp"
#include "output/files/engineering_unit.hpp"
#include "report/charts/chart_columns.hpp"

namespace moat {
namespace {

constexpr const char* of_ground = "ground";

// The heights at which the peaks of a quantity are drawn, by their places: those of the floors themselves, or the
// middle of the storeys below them. A quantity of floors is not looked for at elements, whose names may be the same.
std::map<std::string, double> heights_by_place(const BuildingParts& building, const ModelFacts& model,
                                               const std::string& quantity) {
  std::vector<std::string> names = building.floors;
  names.insert(names.begin(), building.base.empty() ? of_ground : building.base);
  std::vector<double> levels;
  for (const std::string& name : names) {
    const auto node = std::ranges::find_if(model.nodes, [&](const NodeFacts& each) {
      return each.name == name || (!model.diaphragms.empty() && each.name == name + ":x");
    });
    levels.push_back(node == model.nodes.end() ? 0.0 : node->height);
  }
  if (std::ranges::adjacent_find(levels, std::greater_equal{}) != levels.end())
    for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = static_cast<double>(i);
  const bool of_storeys = quantity == "drift" || quantity == "drift_ratio" || quantity.starts_with("storey_shear");
  const bool of_floors_below = quantity.starts_with("corner_drift");
  std::map<std::string, double> heights;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double middle = i == 0 ? levels[0] : 0.5 * (levels[i - 1] + levels[i]);
    const std::string storey = (building.name.empty() ? "" : building.name + " ") + "storey " + std::to_string(i);
    if (of_storeys && i > 0) heights[storey] = middle;
    if (!of_storeys) heights[names[i]] = of_floors_below ? middle : levels[i];
    for (const ElementFacts& element : model.elements)
      if (of_storeys && names[i] != of_ground && element.second == names[i]) heights[element.name] = middle;
  }
  return heights;
}

Series profile(const CaseResult& result, const BuildingParts& building, const std::string& quantity) {
  const std::map<std::string, double> heights = heights_by_place(building, result.model, quantity);
  std::vector<std::pair<double, double>> points;  // height, value
  for (const Peak& peak : result.peaks)
    if (const auto at = heights.find(peak.where); peak.quantity == quantity && at != heights.end())
      points.emplace_back(at->second, engineering_unit(peak.unit).per_si * peak.magnitude());
  // A fixed building begins at the ground.
  if (building.base.empty() && points.size() >= 2 && quantity == "displacement")
    points.emplace_back(heights.at(of_ground), 0.0);
  if (building.base.empty() && points.size() >= 2 && quantity == "absolute_acceleration")
    points.emplace_back(heights.at(of_ground), result.motion.peak_acceleration);
  std::ranges::sort(points);
  Series series{.name = building.name};
  for (const auto& [height, value] : points) {
    series.x.push_back(value);
    series.y.push_back(height);
  }
  return series;
}

}  // namespace

std::vector<Chart> floor_profiles(const CaseResult& result) {
  const bool in_plan = !result.model.diaphragms.empty();
  std::vector<Chart> charts;
  for (const std::string quantity :
       {"displacement", in_plan ? "corner_drift" : "drift", in_plan ? "corner_drift_ratio" : "drift_ratio",
        "absolute_acceleration", in_plan ? "storey_shear_x" : "storey_shear", "storey_shear_y"}) {
    const auto peak = std::ranges::find(result.peaks, quantity, &Peak::quantity);
    if (peak == result.peaks.end()) continue;
    Chart chart{.title = capitalised(in_words(quantity)) + " over height",
                .x_label = "largest " + axis_label(quantity, peak->unit),
                .y_label = "height [m]",
                .second_unit = second_scale(peak->unit, true)};
    for (std::size_t b = 0; b < std::min(result.buildings.size(), most_charted_buildings); ++b) {
      Series series = profile(result, result.buildings[b], quantity);
      if (series.x.size() >= 2) chart.series.push_back(std::move(series));
    }
    if (chart.series.empty()) continue;
    double largest = 0.0, lowest = 0.0;
    for (const Series& series : chart.series) {
      largest = std::max(largest, std::ranges::max(series.x));
      lowest = std::min(lowest, series.y.front());
    }
    chart.y_from_zero = lowest >= 0.0;
    if (largest > 0.0) chart.x_range = std::pair{0.0, 1.05 * largest};
    charts.push_back(std::move(chart));
  }
  return charts;
}

std::vector<Chart> floor_spectra(const CaseResult& result) {
  std::vector<Chart> charts;
  for (const auto& [floor, corner, direction, spectrum] : result.floor_spectra) {
    if (!corner.empty()) continue;
    const std::string title = "Floor response spectra" + (direction.empty() ? "" : " along " + direction);
    const std::string x_label =
        "period of an oscillator with " + to_text(100.0 * spectrum.damping_ratio) + " % damping [s]";
    auto chart =
        std::ranges::find_if(charts, [&](const Chart& each) { return each.title == title && each.x_label == x_label; });
    if (chart == charts.end())
      chart = charts.insert(charts.end(), {.title = title,
                                           .x_label = x_label,
                                           .y_label = axis_label("pseudo-acceleration", "m/s^2"),
                                           .logarithmic_x = true,
                                           .y_from_zero = true,
                                           .second_unit = second_scale("m/s^2")});
    chart->series.push_back({floor, spectrum.period, spectrum.pseudo_acceleration});
  }
  return charts;
}

}  // namespace moat
