#include <algorithm>
#include <limits>
#include <string>

#include "output/charts/chart.hpp"

namespace moat {
namespace {

// The curves of a chart, of a band that goes forth and back over the same x its two edges.
std::vector<Series> curves_of(const Chart& chart) {
  std::vector<Series> curves;
  for (const Series& series : chart.series) {
    const auto &x = series.x, &y = series.y;
    const auto half = static_cast<std::ptrdiff_t>(x.size() / 2);
    if (series.style != Series::Style::band || !std::equal(x.begin(), x.end(), x.rbegin())) {
      curves.push_back(series);
      continue;
    }
    curves.push_back({series.name + ", first edge", {x.begin(), x.begin() + half}, {y.begin(), y.begin() + half}});
    curves.push_back({series.name + ", second edge", {x.begin(), x.begin() + half}, {y.rbegin(), y.rbegin() + half}});
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
  for (const Series& series : curves) {
    if (!shared || table.columns.empty())
      table.columns.push_back(column_of(chart.x_label, shared ? "" : series.name, series.x, rows));
    table.columns.push_back(column_of(chart.y_label, series.name, series.y, rows));
  }
  return table;
}

}  // namespace moat
