#include "output/charts/chart_table.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace moat {
namespace {

// Both edges of a band whose line goes forth and back over the same x.
bool is_band(const Series& series) {
  const std::size_t count = series.x.size();
  if (series.style != Series::Style::band || count % 2 != 0) return false;
  for (std::size_t i = 0; i < count / 2; ++i)
    if (series.x[i] != series.x[count - 1 - i]) return false;
  return true;
}

// The curves of a chart, of a band its two edges.
std::vector<Series> curves_of(const Chart& chart) {
  std::vector<Series> curves;
  for (const Series& series : chart.series) {
    if (!is_band(series)) {
      curves.push_back(series);
      continue;
    }
    const auto half = static_cast<std::ptrdiff_t>(series.x.size() / 2);
    const std::vector<double> x{series.x.begin(), series.x.begin() + half};
    curves.push_back({series.name + ", first edge", x, {series.y.begin(), series.y.begin() + half}});
    curves.push_back({series.name + ", second edge", x, {series.y.rbegin(), series.y.rbegin() + half}});
  }
  return curves;
}

Column column_of(const std::string& label, const std::string& where, std::vector<double> values, std::size_t rows) {
  const std::size_t bracket = label.rfind(" [");
  const bool has_unit = bracket != std::string::npos && label.ends_with(']');
  values.resize(rows, std::numeric_limits<double>::quiet_NaN());
  return {has_unit ? label.substr(0, bracket) : label, where,
          has_unit ? label.substr(bracket + 2, label.size() - bracket - 3) : "1", std::move(values)};
}

}  // namespace

Table table_of(const Chart& chart) {
  Table table;
  const std::vector<Series> curves = curves_of(chart);
  std::size_t rows = 0;
  for (const Series& series : curves) rows = std::max(rows, series.x.size());
  const bool shared = std::ranges::all_of(curves, [&](const Series& series) { return series.x == curves.front().x; });
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Series& series = curves[i];
    if (i == 0 || !shared) table.columns.push_back(column_of(chart.x_label, shared ? "" : series.name, series.x, rows));
    table.columns.push_back(column_of(chart.y_label, series.name, series.y, rows));
  }
  return table;
}

}  // namespace moat
