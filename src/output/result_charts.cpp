#include "output/result_charts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "output/engineering_unit.hpp"
#include "output/table_columns.hpp"

namespace moat {
namespace {

std::vector<const Column*> columns_of(const Table& table, std::string_view quantity) {
  std::vector<const Column*> found;
  for (const Column& column : table.columns)
    if (column.quantity == quantity && !column.values.empty()) found.push_back(&column);
  return found;
}

constexpr std::size_t most_buildings = 3;  // so that a chart stays legible

const Column* column_of(const std::vector<const Column*>& columns, const std::string& where) {
  const auto found = std::ranges::find_if(columns, [&](const Column* column) { return column->where == where; });
  return found == columns.end() ? nullptr : *found;
}

// The last column if the model has no building.
std::vector<const Column*> bases_and_tops(const CaseResult& result, std::string_view quantity) {
  const std::vector<const Column*> columns = columns_of(result.histories, quantity);
  std::vector<const Column*> picked;
  for (std::size_t b = 0; b < std::min(result.buildings.size(), most_buildings); ++b) {
    const BuildingParts& building = result.buildings[b];
    const std::string& top = building.floors.empty() ? building.base : building.floors.back();
    for (const std::string& where : {building.base, top}) {
      const Column* column = column_of(columns, where);
      if (column != nullptr && std::ranges::find(picked, column) == picked.end()) picked.push_back(column);
    }
  }
  if (picked.empty() && !columns.empty()) picked.push_back(columns.back());
  return picked;
}

std::vector<double> scaled(const Column& column) {
  const double factor = engineering_unit(column.unit).per_si;
  std::vector<double> values = column.values;
  for (double& value : values) value *= factor;
  return values;
}

std::string axis_label(const Column& column) {
  return in_words(column.quantity) + " [" + with_raised_digits(engineering_unit(column.unit).symbol) + "]";
}

Chart history_chart(const Column& time, const std::vector<const Column*>& columns) {
  Chart chart;
  chart.title = capitalised(in_words(columns.front()->quantity));
  chart.x_label = "time [s]";
  chart.y_label = axis_label(*columns.front());
  chart.x_range = std::pair{time.values.front(), time.values.back()};
  for (const Column* column : columns) chart.series.push_back({column->where, time.values, scaled(*column)});
  return chart;
}

// Both components of the first bearing.
std::optional<Chart> hysteresis_in_plan(const CaseResult& result) {
  Chart loop;
  for (const char* component : {"_x", "_y"}) {
    const std::vector<const Column*> forces = columns_of(result.histories, "isolator_force" + std::string{component}),
                                     deformations =
                                         columns_of(result.histories, "isolator_deformation" + std::string{component});
    if (forces.empty() || deformations.empty() || forces.front()->where != deformations.front()->where)
      return std::nullopt;
    loop.series.push_back({forces.front()->where + (component[1] == 'x' ? ", along x" : ", along y"),
                           scaled(*deformations.front()), scaled(*forces.front())});
    loop.x_label = "deformation [" + engineering_unit("m").symbol + "]";
    loop.y_label = "force [" + engineering_unit("N").symbol + "]";
  }
  loop.title = "Bearing";
  return loop;
}

}  // namespace

std::vector<Chart> history_charts(const CaseResult& result) {
  const Table& table = result.histories;
  require_equal_lengths(table);
  const std::vector<const Column*> times = columns_of(table, "time");
  std::vector<Chart> charts;
  if (times.empty() || times.front()->values.back() <= times.front()->values.front()) return charts;
  std::vector<std::vector<const Column*>> groups;
  if (result.model.diaphragms.empty()) {
    groups = {bases_and_tops(result, "displacement"), bases_and_tops(result, "absolute_acceleration")};
  } else {
    for (const char* quantity :
         {"displacement_x", "displacement_y", "rotation", "absolute_acceleration_x", "absolute_acceleration_y"})
      groups.push_back(bases_and_tops(result, quantity));
  }
  groups.push_back(columns_of(table, "impact_force"));
  for (const auto& columns : groups)
    if (!columns.empty()) charts.push_back(history_chart(*times.front(), columns));
  for (std::size_t i = 0; i < result.offered.size(); ++i) {
    const std::string& quantity = result.offered[i].quantity;
    const auto same = [&](const OfferedQuantity& each) { return each.quantity == quantity; };
    if (std::find_if(result.offered.begin(), result.offered.end(), same) - result.offered.begin() !=
        static_cast<std::ptrdiff_t>(i))
      continue;  // in the chart of the first one
    std::vector<const Column*> columns = columns_of(table, quantity);
    // A curve with a value that is not finite, or whose range may not be, cannot be drawn.
    constexpr double largest = 1e300;
    std::erase_if(columns, [](const Column* column) {
      return !std::ranges::all_of(column->values, [](double value) { return std::abs(value) <= largest; });
    });
    if (!columns.empty()) charts.push_back(history_chart(*times.front(), columns));
  }
  return charts;
}

std::optional<Chart> hysteresis_chart(const CaseResult& result) {
  const Table& table = result.histories;
  require_equal_lengths(table);
  if (!result.model.diaphragms.empty()) return hysteresis_in_plan(result);
  const std::vector<const Column*> forces = columns_of(table, "isolator_force");
  const std::vector<const Column*> displacements = columns_of(table, "displacement");
  for (const BuildingParts& building : result.buildings) {
    const Column* base = column_of(displacements, building.base);
    const Column* force = building.isolators.empty() ? nullptr : column_of(forces, building.isolators.front());
    if (base == nullptr || force == nullptr) continue;
    Chart loop;
    loop.title = "Isolators";
    loop.x_label = base->where + " displacement [" + engineering_unit(base->unit).symbol + "]";
    loop.y_label = axis_label(*force);
    loop.series.push_back({force->where, scaled(*base), scaled(*force)});
    return loop;
  }
  return std::nullopt;
}

}  // namespace moat
