#include "report/charts/chart_columns.hpp"

#include <algorithm>
#include <map>

#include "output/files/engineering_unit.hpp"
#include "report/charts/result_charts.hpp"

namespace moat {

std::vector<const Column*> columns_of(const Table& table, std::string_view quantity) {
  std::vector<const Column*> found;
  for (const Column& column : table.columns)
    if (column.quantity == quantity && !column.values.empty()) found.push_back(&column);
  return found;
}

const Column* column_of(const Table& table, std::string_view quantity, std::string_view where) {
  const auto found = std::ranges::find_if(table.columns, [&](const Column& column) {
    return column.quantity == quantity && column.where == where && !column.values.empty();
  });
  return found == table.columns.end() ? nullptr : &*found;
}

std::vector<const Column*> bases_and_tops(const CaseResult& result, const Table& table, std::string_view quantity) {
  std::vector<const Column*> picked;
  for (std::size_t b = 0; b < std::min(result.buildings.size(), most_charted_buildings); ++b) {
    const BuildingParts& building = result.buildings[b];
    for (const std::string& where : {building.base, building.floors.empty() ? building.base : building.floors.back()}) {
      const Column* column = column_of(table, quantity, where);
      if (column != nullptr && std::ranges::find(picked, column) == picked.end()) picked.push_back(column);
    }
  }
  const std::vector<const Column*> columns = columns_of(table, quantity);
  if (picked.empty() && !columns.empty()) picked.push_back(columns.back());
  return picked;
}

std::vector<double> in_engineering_unit(const Column& column, const ChartRows* rows) {
  const double factor = engineering_unit(column.unit).per_si;
  std::vector<double> values(rows != nullptr ? rows->size() : column.values.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = factor * column.values[rows != nullptr ? (*rows)[i] : i];
  return values;
}

std::optional<SecondUnit> second_scale(std::string_view si_unit, bool of_x) {
  const EngineeringUnit unit = second_unit(si_unit);
  if (unit.symbol.empty()) return std::nullopt;
  return SecondUnit{unit.symbol, unit.per_si / engineering_unit(si_unit).per_si, of_x};
}

std::string axis_label(std::string_view quantity, std::string_view si_unit) {
  return in_words(quantity) + " [" + with_raised_digits(engineering_unit(si_unit).symbol) + "]";
}

std::vector<NodeMotion> motions_of_nodes(const CaseResult& result) {
  const Table& histories = result.histories;
  std::map<std::string, NodeMotion> in_plan;  // by the name of the node
  for (const DiaphragmFacts& diaphragm : result.model.diaphragms) {
    const std::string& name = diaphragm.name;
    in_plan[name + ":x"] = {column_of(histories, "displacement_x", name)};
    in_plan[name + ":y"] = {column_of(histories, "displacement_y", name)};
    in_plan[name + ":r"] = {column_of(histories, "rotation", name), diaphragm.gyration};
  }
  std::vector<NodeMotion> motions;
  for (const NodeFacts& node : result.model.nodes) {
    const auto found = in_plan.find(node.name);
    motions.push_back(found != in_plan.end() ? found->second
                                             : NodeMotion{column_of(histories, "displacement", node.name)});
  }
  return motions;
}

}  // namespace moat
