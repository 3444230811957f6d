#include "output/result_charts.hpp"

#include <algorithm>
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

bool is_base(const Column& column) { return column.where == "base" || column.where.ends_with(" base"); }

/// The base, if there is one, and the last column.
std::vector<const Column*> base_and_top(const Table& table, std::string_view quantity) {
  const std::vector<const Column*> all = columns_of(table, quantity);
  std::vector<const Column*> picked;
  const auto base = std::find_if(all.begin(), all.end(), [](const Column* column) { return is_base(*column); });
  if (base != all.end()) picked.push_back(*base);
  if (!all.empty() && (picked.empty() || all.back() != picked.front())) picked.push_back(all.back());
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

}  // namespace

std::vector<Chart> history_charts(const CaseResult& result) {
  const Table& table = result.histories;
  require_equal_lengths(table);
  const std::vector<const Column*> times = columns_of(table, "time");
  std::vector<Chart> charts;
  if (times.empty() || times.front()->values.back() <= times.front()->values.front()) return charts;
  for (const auto& columns : {base_and_top(table, "displacement"), base_and_top(table, "absolute_acceleration"),
                              columns_of(table, "impact_force")})
    if (!columns.empty()) charts.push_back(history_chart(*times.front(), columns));
  return charts;
}

std::optional<Chart> hysteresis_chart(const CaseResult& result) {
  const Table& table = result.histories;
  require_equal_lengths(table);
  const std::vector<const Column*> forces = columns_of(table, "isolator_force");
  const std::vector<const Column*> displacements = base_and_top(table, "displacement");
  if (forces.empty() || displacements.empty() || !is_base(*displacements.front())) return std::nullopt;
  Chart loop;
  loop.title = "Isolators";
  loop.x_label = "base displacement [" + engineering_unit(displacements.front()->unit).symbol + "]";
  loop.y_label = axis_label(*forces.front());
  loop.series.push_back({forces.front()->where, scaled(*displacements.front()), scaled(*forces.front())});
  return loop;
}

}  // namespace moat
