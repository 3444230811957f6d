#include "report/charts/result_charts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "base/units.hpp"
#include "motions/response_spectrum.hpp"
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

constexpr double damping_ratio = 0.05;
constexpr double longest_period = 5.0;  // s

std::vector<Time> periods_from(double shortest) {
  constexpr int count = 100;
  std::vector<Time> periods;
  for (int i = 0; i < count; ++i)
    periods.push_back(shortest * std::pow(longest_period / shortest, i / (count - 1.0)) * units::s);
  return periods;
}

// A motion of the ground is limited; that of a floor that hits something very stiff may not be.
bool can_be_a_motion(const Column& column) {
  constexpr double largest = 1e6;  // m/s^2
  return std::ranges::all_of(column.values, [](double value) { return std::abs(value) <= largest; });
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
  constexpr std::size_t least_rows = 100;
  const Table& table = result.floor_accelerations.rows() > 0 ? result.floor_accelerations : result.histories;
  const std::vector<const Column*> times = columns_of(table, "time");
  if (times.empty() || times.front()->values.size() < least_rows) return {};
  const double interval = times.front()->values[1] - times.front()->values[0];
  const double shortest = std::max(0.05, 2.0 * interval);
  if (shortest >= longest_period) return {};
  const std::vector<Time> periods = periods_from(shortest);
  std::vector<Chart> charts;
  for (const char* component : {"", "_x", "_y"}) {
    // In plan those without component are resultants.
    if ((*component == '\0') != result.model.diaphragms.empty()) continue;
    Chart chart{.title = "Floor response spectra" + (*component == '\0' ? "" : std::string{" along "} + component[1]),
                .x_label = "period of an oscillator with 5 % damping [s]",
                .y_label = axis_label("pseudo-acceleration", "m/s^2"),
                .logarithmic_x = true,
                .y_from_zero = true,
                .second_unit = second_scale("m/s^2")};
    for (const Column* column : bases_and_tops(result, table, std::string{"absolute_acceleration"} + component)) {
      if (!can_be_a_motion(*column)) continue;
      const ResponseSpectrum spectrum =
          response_spectrum(GroundMotion{column->where, interval, column->values}, periods, damping_ratio);
      chart.series.push_back({column->where, spectrum.period, spectrum.pseudo_acceleration});
    }
    if (!chart.series.empty()) charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace moat
