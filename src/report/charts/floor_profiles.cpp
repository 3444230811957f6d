#include "report/charts/floor_profiles.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "output/files/engineering_unit.hpp"
#include "report/charts/chart_columns.hpp"
#include "report/charts/history_charts.hpp"

namespace moat {
namespace {

// Names of floors from the lowest up, with the heights at which they and the storeys below them are drawn.
struct Levels {
  std::vector<std::string> names;
  std::vector<double> heights;

  [[nodiscard]] double middle_below(std::size_t level) const {
    return level == 0 ? heights[0] : 0.5 * (heights[level - 1] + heights[level]);
  }
};

Levels levels_of(const BuildingParts& building, const ModelFacts& model) {
  Levels levels;
  if (!building.base.empty()) levels.names.push_back(building.base);
  levels.names.insert(levels.names.end(), building.floors.begin(), building.floors.end());
  for (const std::string& name : levels.names) {
    const auto node = std::ranges::find_if(model.nodes, [&](const NodeFacts& each) {
      return each.name == name || (!model.diaphragms.empty() && each.name == name + ":x");
    });
    levels.heights.push_back(node == model.nodes.end() ? 0.0 : node->height);
  }
  for (std::size_t i = 1; i < levels.heights.size(); ++i) {
    if (levels.heights[i] > levels.heights[i - 1]) continue;
    for (std::size_t level = 0; level < levels.heights.size(); ++level)
      levels.heights[level] = static_cast<double>(level);
    break;
  }
  return levels;
}

// The heights at which the peaks of a quantity are drawn, by their places: those of the floors themselves, or the
// middle of the storeys below them. A quantity of floors is not looked for at elements, whose names may be the same.
std::map<std::string, double> heights_by_place(const Levels& levels, const ModelFacts& model,
                                               const std::string& quantity) {
  const bool of_storeys = quantity == "drift" || quantity == "storey_shear";
  std::map<std::string, double> heights;
  for (std::size_t i = 0; i < levels.names.size(); ++i) {
    const double middle = levels.middle_below(i);
    if (!of_storeys) heights[levels.names[i]] = quantity == "corner_drift" ? middle : levels.heights[i];
    for (const ElementFacts& element : model.elements)
      if (of_storeys && element.second == levels.names[i]) heights[element.name] = middle;
  }
  return heights;
}

Series profile(const CaseResult& result, const BuildingParts& building, const std::string& quantity) {
  const Levels levels = levels_of(building, result.model);
  const std::map<std::string, double> heights = heights_by_place(levels, result.model, quantity);
  std::vector<std::pair<double, double>> points;  // height, value
  for (const Peak& peak : result.peaks)
    if (const auto at = heights.find(peak.where); peak.quantity == quantity && at != heights.end())
      points.emplace_back(at->second, engineering_unit(peak.unit).per_si * peak.magnitude());
  std::ranges::sort(points);
  Series series{.name = building.name, .x = {}, .y = {}};
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
       {"displacement", in_plan ? "corner_drift" : "drift", "absolute_acceleration", "storey_shear"}) {
    const auto peak = std::ranges::find(result.peaks, quantity, &Peak::quantity);
    if (peak == result.peaks.end()) continue;
    Chart chart;
    chart.title = capitalised(in_words(quantity)) + " over height";
    chart.x_label = "largest " + axis_label(quantity, peak->unit);
    chart.y_label = "height [m]";
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

}  // namespace moat
