#include "output/result_charts.hpp"

#include <algorithm>
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

// The columns of one quantity that belong to one building.
struct BuildingColumns {
  std::string prefix{};  // before "base" and "floor 1": "" or "north "
  const Column* base = nullptr;
  const Column* top = nullptr;
  bool has_floors = false;
};

constexpr std::string_view base_name = "base", floor_name = "floor ", wall_name = " wall";
constexpr std::size_t most_buildings = 3;

bool starts_word(std::string_view text, std::size_t at) { return at == 0 || text[at - 1] == ' '; }

std::optional<std::string> prefix_of_base(std::string_view where) {
  if (!where.ends_with(base_name)) return std::nullopt;
  const std::size_t at = where.size() - base_name.size();
  if (!starts_word(where, at)) return std::nullopt;
  return std::string{where.substr(0, at)};
}

std::optional<std::string> prefix_of_floor(std::string_view where) {
  const std::size_t at = where.rfind(floor_name);
  if (at == std::string_view::npos || !starts_word(where, at)) return std::nullopt;
  const std::string_view number = where.substr(at + floor_name.size());
  if (number.empty() || number.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  return std::string{where.substr(0, at)};
}

// Buildings by the names of their nodes, in order; at most three, so that a chart stays legible.
std::vector<BuildingColumns> buildings_of(const std::vector<const Column*>& columns) {
  std::vector<BuildingColumns> buildings;
  const auto index_of = [&](const std::string& prefix) {
    const auto known = std::ranges::find(buildings, prefix, &BuildingColumns::prefix);
    const auto index = static_cast<std::size_t>(known - buildings.begin());
    if (known == buildings.end()) buildings.push_back({.prefix = prefix});
    return index;
  };
  std::optional<std::size_t> last_with_base;
  for (const Column* column : columns) {
    const std::string& where = column->where;
    if (const auto base_prefix = prefix_of_base(where)) {
      last_with_base = index_of(*base_prefix);
      buildings[*last_with_base].base = column;
    } else if (const auto floor_prefix = prefix_of_floor(where)) {
      BuildingColumns& building = buildings[index_of(*floor_prefix)];
      building.top = column;
      building.has_floors = true;
    } else if (last_with_base) {
      BuildingColumns& building = buildings[*last_with_base];
      if (!building.has_floors && where.starts_with(building.prefix) && !where.ends_with(wall_name))
        building.top = column;
    }
  }
  if (buildings.empty() && !columns.empty()) buildings.push_back({.top = columns.back()});
  if (buildings.size() > most_buildings) buildings.resize(most_buildings);
  return buildings;
}

std::vector<const Column*> bases_and_tops(const Table& table, std::string_view quantity) {
  std::vector<const Column*> picked;
  for (const BuildingColumns& building : buildings_of(columns_of(table, quantity)))
    for (const Column* column : {building.base, building.top})
      if (column != nullptr) picked.push_back(column);
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
  for (const auto& columns : {bases_and_tops(table, "displacement"), bases_and_tops(table, "absolute_acceleration"),
                              columns_of(table, "impact_force")})
    if (!columns.empty()) charts.push_back(history_chart(*times.front(), columns));
  return charts;
}

std::optional<Chart> hysteresis_chart(const CaseResult& result) {
  const Table& table = result.histories;
  require_equal_lengths(table);
  const std::vector<const Column*> forces = columns_of(table, "isolator_force");
  if (forces.empty()) return std::nullopt;
  const auto buildings = buildings_of(columns_of(table, "displacement"));
  const auto isolated = std::ranges::find_if(buildings, [](const auto& building) { return building.base != nullptr; });
  if (isolated == buildings.end()) return std::nullopt;
  // That building's own, where names tell.
  const auto own =
      std::ranges::find_if(forces, [&](const Column* force) { return force->where.starts_with(isolated->prefix); });
  const Column& force = own == forces.end() ? *forces.front() : **own;
  Chart loop;
  loop.title = "Isolators";
  loop.x_label = isolated->prefix + "base displacement [" + engineering_unit(isolated->base->unit).symbol + "]";
  loop.y_label = axis_label(force);
  loop.series.push_back({force.where, scaled(*isolated->base), scaled(force)});
  return loop;
}

}  // namespace moat
