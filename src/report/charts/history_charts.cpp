#include "report/charts/history_charts.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "output/files/engineering_unit.hpp"
#include "output/files/table_columns.hpp"
#include "report/charts/chart_columns.hpp"

namespace moat {
namespace {

Chart history_chart(const Column& time, const std::vector<const Column*>& columns) {
  Chart chart;
  chart.title = capitalised(in_words(columns.front()->quantity));
  chart.x_label = "time [s]";
  chart.y_label = axis_label(columns.front()->quantity, columns.front()->unit);
  chart.x_range = std::pair{time.values.front(), time.values.back()};
  for (const Column* column : columns)
    chart.series.push_back({column->where, time.values, in_engineering_unit(*column)});
  return chart;
}

// A curve with a value that is not finite, or whose range may not be, cannot be drawn.
bool can_be_drawn(const Column& column) {
  constexpr double largest = 1e300;
  return std::ranges::all_of(column.values, [](double value) { return std::abs(value) <= largest; });
}

bool is_zero(const Column* column) {
  return std::ranges::all_of(column->values, [](double value) { return value == 0.0; });
}

// Those of the gaps that closed; of all where none did.
std::vector<const Column*> impact_forces(const Table& table) {
  std::vector<const Column*> forces = columns_of(table, "impact_force");
  if (!std::ranges::all_of(forces, is_zero)) std::erase_if(forces, is_zero);
  return forces;
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
    groups = {bases_and_tops(result, result.histories, "displacement"),
              bases_and_tops(result, result.histories, "absolute_acceleration")};
  } else {
    for (const char* quantity :
         {"displacement_x", "displacement_y", "rotation", "absolute_acceleration_x", "absolute_acceleration_y"})
      groups.push_back(bases_and_tops(result, result.histories, quantity));
  }
  groups.push_back(impact_forces(table));
  std::set<std::string> offered;
  for (const OfferedQuantity& each : result.offered)
    if (offered.insert(each.quantity).second) groups.push_back(columns_of(table, each.quantity));
  for (std::vector<const Column*>& columns : groups) {
    std::erase_if(columns, [](const Column* column) { return !can_be_drawn(*column); });
    if (!columns.empty()) charts.push_back(history_chart(*times.front(), columns));
  }
  return charts;
}

}  // namespace moat
