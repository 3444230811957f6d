#include "report/charts/floor_spectra.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "motions/response_spectrum.hpp"
#include "report/charts/chart_columns.hpp"

namespace moat {
namespace {

constexpr double damping_ratio = 0.05;
constexpr double longest_period = 5.0;  // s

std::vector<Time> periods_from(double shortest) {
  constexpr int count = 100;
  std::vector<Time> periods;
  for (int i = 0; i < count; ++i)
    periods.push_back(shortest * std::pow(longest_period / shortest, i / (count - 1.0)) * units::s);
  return periods;
}

// A motion of the ground is limited; that of a floor that hits something very stiff may not be.
bool can_be_a_motion(const Column& column) {
  constexpr double largest = 1e6;  // m/s^2
  return std::ranges::all_of(column.values, [](double value) { return std::abs(value) <= largest; });
}

}  // namespace

std::vector<Chart> floor_spectra(const CaseResult& result) {
  constexpr std::size_t least_rows = 100;
  const Table& table = result.floor_accelerations.rows() > 0 ? result.floor_accelerations : result.histories;
  const std::vector<const Column*> times = columns_of(table, "time");
  if (times.empty() || times.front()->values.size() < least_rows) return {};
  const double interval = times.front()->values[1] - times.front()->values[0];
  const double shortest = std::max(0.05, 2.0 * interval);
  if (shortest >= longest_period) return {};
  const std::vector<Time> periods = periods_from(shortest);
  std::vector<Chart> charts;
  for (const char* component : {"", "_x", "_y"}) {
    // In plan those without component are resultants.
    if ((*component == '\0') != result.model.diaphragms.empty()) continue;
    Chart chart;
    chart.title = "Floor response spectra" + (*component == '\0' ? "" : std::string{" along "} + component[1]);
    chart.x_label = "period of an oscillator with 5 % damping [s]";
    chart.y_label = axis_label("pseudo-acceleration", "m/s^2");
    chart.logarithmic_x = true;
    chart.y_from_zero = true;
    for (const Column* column : bases_and_tops(result, table, std::string{"absolute_acceleration"} + component)) {
      if (!can_be_a_motion(*column)) continue;
      const ResponseSpectrum spectrum =
          response_spectrum(GroundMotion{column->where, interval, column->values}, periods, damping_ratio);
      chart.series.push_back({column->where, spectrum.period, spectrum.pseudo_acceleration});
    }
    if (!chart.series.empty()) charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace moat
