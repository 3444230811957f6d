#include "report/charts/isolator_loops.hpp"

#include <algorithm>
#include <cmath>

#include "output/files/table_columns.hpp"
#include "report/charts/chart_columns.hpp"
#include "report/charts/history_charts.hpp"

namespace moat {
namespace {

Chart empty_chart(std::string title) {
  Chart chart;
  chart.title = std::move(title);
  chart.x_label = axis_label("deformation", "m");
  chart.y_label = axis_label("force", "N");
  return chart;
}

double largest(const Column& column) {
  double value = 0.0;
  for (const double each : column.values) value = std::max(value, std::abs(each));
  return value;
}

std::vector<Chart> loops_in_plan(const Table& table) {
  const Column* widest = nullptr;
  for (const char* quantity : {"isolator_deformation_x", "isolator_deformation_y"})
    for (const Column* column : columns_of(table, quantity))
      if (widest == nullptr || largest(*column) > largest(*widest)) widest = column;
  if (widest == nullptr) return {};
  Chart chart = empty_chart("Loops of " + widest->where);
  for (const std::string component : {"x", "y"}) {
    const Column* deformation = column_of(columns_of(table, "isolator_deformation_" + component), widest->where);
    const Column* force = column_of(columns_of(table, "isolator_force_" + component), widest->where);
    if (deformation == nullptr || force == nullptr) return {};
    chart.series.push_back({"along " + component, in_engineering_unit(*deformation), in_engineering_unit(*force)});
  }
  return {chart};
}

}  // namespace

std::vector<Chart> isolator_loops(const CaseResult& result) {
  const Table& table = result.histories;
  require_equal_lengths(table);
  if (!result.model.diaphragms.empty()) return loops_in_plan(table);
  const std::vector<const Column*> forces = columns_of(table, "isolator_force"),
                                   deformations = columns_of(table, "isolator_deformation");
  std::vector<Chart> charts;
  for (const BuildingParts& building : result.buildings) {
    if (charts.size() == most_charted_buildings) break;
    Chart chart = empty_chart(building.name.empty() ? "Loops of the isolators" : "Isolators of " + building.name);
    for (const std::string& isolator : building.isolators) {
      const Column *force = column_of(forces, isolator), *deformation = column_of(deformations, isolator);
      if (force != nullptr && deformation != nullptr)
        chart.series.push_back({isolator, in_engineering_unit(*deformation), in_engineering_unit(*force)});
    }
    if (!chart.series.empty()) charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace moat
