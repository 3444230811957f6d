#include "report/floor_profiles.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "output/engineering_unit.hpp"
#include "report/chart_columns.hpp"
#include "report/history_charts.hpp"

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
    const auto node = std::ranges::find_if(
        model.nodes, [&](const NodeFacts& each) { return each.name == name || each.name == name + ":x"; });
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

// Where the peak of a place is drawn: at a floor, or at the storey that an element forms below it.
class Places {
 public:
  Places(const Levels& levels, const ModelFacts& model) {
    for (std::size_t i = 0; i < levels.names.size(); ++i) level_[levels.names[i]] = i;
    for (const ElementFacts& element : model.elements)
      if (const auto upper = level_.find(element.second); upper != level_.end()) storey_[element.name] = upper->second;
  }

  [[nodiscard]] const std::size_t* floor(const std::string& where) const { return found(level_, where); }
  [[nodiscard]] const std::size_t* storey(const std::string& where) const { return found(storey_, where); }

 private:
  using Map = std::map<std::string, std::size_t>;
  static const std::size_t* found(const Map& map, const std::string& where) {
    const auto entry = map.find(where);
    return entry == map.end() ? nullptr : &entry->second;
  }

  Map level_, storey_;
};

Series profile(const CaseResult& result, const BuildingParts& building, const std::string& quantity) {
  const Levels levels = levels_of(building, result.model);
  const Places places{levels, result.model};
  std::vector<std::pair<double, double>> points;  // height, value
  for (const Peak& peak : result.peaks) {
    if (peak.quantity != quantity) continue;
    const double value = engineering_unit(peak.unit).per_si * peak.magnitude();
    const bool is_drift = quantity == "corner_drift";
    if (const std::size_t* level = places.floor(peak.where))
      points.emplace_back(is_drift ? levels.middle_below(*level) : levels.heights[*level], value);
    else if (const std::size_t* storey = places.storey(peak.where))
      points.emplace_back(levels.middle_below(*storey), value);
  }
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
