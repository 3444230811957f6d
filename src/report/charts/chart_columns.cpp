#include "report/charts/chart_columns.hpp"

#include <algorithm>

#include "output/files/engineering_unit.hpp"
#include "report/charts/history_charts.hpp"

namespace moat {

std::vector<const Column*> columns_of(const Table& table, std::string_view quantity) {
  std::vector<const Column*> found;
  for (const Column& column : table.columns)
    if (column.quantity == quantity && !column.values.empty()) found.push_back(&column);
  return found;
}

const Column* column_of(const std::vector<const Column*>& columns, const std::string& where) {
  const auto found = std::ranges::find_if(columns, [&](const Column* column) { return column->where == where; });
  return found == columns.end() ? nullptr : *found;
}

std::vector<const Column*> bases_and_tops(const CaseResult& result, const Table& table, std::string_view quantity) {
  const std::vector<const Column*> columns = columns_of(table, quantity);
  std::vector<const Column*> picked;
  for (std::size_t b = 0; b < std::min(result.buildings.size(), most_charted_buildings); ++b) {
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

std::vector<double> in_engineering_unit(const Column& column) {
  const double factor = engineering_unit(column.unit).per_si;
  std::vector<double> values = column.values;
  for (double& value : values) value *= factor;
  return values;
}

std::string axis_label(std::string_view quantity, std::string_view si_unit) {
  return in_words(quantity) + " [" + with_raised_digits(engineering_unit(si_unit).symbol) + "]";
}

}  // namespace moat
