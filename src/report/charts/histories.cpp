#include "report/charts/result_charts.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "output/charts/chart_style.hpp"
#include "output/files/engineering_unit.hpp"
#include "report/charts/chart_columns.hpp"

namespace moat {
namespace {

ChartRows every_row(std::size_t rows, std::size_t stride) {
  ChartRows chosen;
  for (std::size_t row = 0; row < rows; row += stride) chosen.push_back(row);
  return chosen;
}

/// The rows of a picture. A long history is cut into equal pieces of time: the rows are those where a curve is smallest
/// or largest in a piece, and the first and the last one. Charts take little memory beside the histories, since more
/// curves have fewer pieces.
ChartRows rows_of_picture(const std::vector<const Column*>& columns) {
  const std::size_t rows = columns.front()->values.size(), length = rows * 2 * columns.size() / most_rows_of_charts + 1;
  if (rows <= most_rows_of_charts) return every_row(rows, 1);
  std::set<std::size_t> chosen{0, rows - 1};
  for (const Column* column : columns)
    for (std::size_t begin = 0; begin < rows; begin += length) {
      const auto first = column->values.begin();
      const auto [lowest, highest] =
          std::minmax_element(first + static_cast<std::ptrdiff_t>(begin),
                              first + static_cast<std::ptrdiff_t>(std::min(begin + length, rows)));
      chosen.insert({static_cast<std::size_t>(lowest - first), static_cast<std::size_t>(highest - first)});
    }
  return {chosen.begin(), chosen.end()};
}

Chart history_chart(const Column& time, const std::vector<const Column*>& columns, std::size_t stride) {
  const Column& first = *columns.front();
  const ChartRows rows = stride > 0 ? every_row(time.values.size(), stride) : rows_of_picture(columns);
  Chart chart{.title = capitalised(in_words(first.quantity)),
              .x_label = "time [s]",
              .y_label = axis_label(first.quantity, first.unit),
              .x_range = std::pair{time.values.front(), time.values.back()},
              .second_unit = second_scale(first.unit)};
  for (const Column* column : columns)
    chart.series.push_back({column->where, in_engineering_unit(time, &rows), in_engineering_unit(*column, &rows)});
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

// Returns the forces of the gaps that closed; of many the largest, one for each colour.
std::vector<const Column*> impact_forces(const Table& table) {
  std::vector<const Column*> forces = columns_of(table, "impact_force");
  std::erase_if(forces, is_zero);
  constexpr std::size_t most = chart_style::palette.size();
  if (forces.size() <= most) return forces;
  std::ranges::stable_sort(forces, std::ranges::greater{},
                           [](const Column* column) { return std::ranges::max(column->values); });
  forces.resize(most);
  return forces;
}

}  // namespace

std::vector<Chart> history_charts(const CaseResult& result, std::size_t stride) {
  const Table& table = result.histories;
  require_equal_lengths(table);
  const Column* time = column_of(table, "time", "");
  std::vector<Chart> charts;
  if (time == nullptr || time->values.back() <= time->values.front()) return charts;
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
    if (!columns.empty()) charts.push_back(history_chart(*time, columns, stride));
  }
  return charts;
}

std::optional<Chart> energy_chart(const CaseResult& result) {
  const auto energy = [&](const std::string& name) {
    return column_of(result.histories, name + "_energy", "structure");
  };
  const Column *time = column_of(result.histories, "time", ""), *input = energy("input");
  if (time == nullptr || time->values.size() < 2 || input == nullptr) return std::nullopt;
  Chart chart{.title = "Energy", .x_label = "time [s]", .y_label = axis_label("energy", "J")};
  // Energies that only grow lie at the bottom, those that come and go on top.
  std::vector<const Column*> parts;
  for (const char* name : {"hysteretic", "viscous", "impact", "friction", "strain", "kinetic"})
    if (const Column* part = energy(name); part != nullptr && !is_zero(part)) parts.push_back(part);
  std::vector<const Column*> drawn = parts;
  drawn.push_back(input);
  const ChartRows rows = rows_of_picture(drawn);
  const std::vector<double> times = in_engineering_unit(*time, &rows);
  std::vector<double> below(rows.size(), 0.0);
  for (const Column* part : parts) {
    const std::vector<double> values = in_engineering_unit(*part, &rows);
    Series band{.name = part->quantity.substr(0, part->quantity.find('_')),
                .x = times,
                .y = below,
                .style = Series::Style::band};
    for (std::size_t i = 0; i < below.size(); ++i) below[i] += values[i];
    band.x.insert(band.x.end(), times.rbegin(), times.rend());
    band.y.insert(band.y.end(), below.rbegin(), below.rend());
    chart.series.push_back(std::move(band));
  }
  chart.series.push_back({.name = "input", .x = times, .y = in_engineering_unit(*input, &rows), .colour = 6});
  return chart;
}

}  // namespace moat
