#include "report/charts/energy_chart.hpp"

#include "output/recorders/energy_columns.hpp"
#include "report/charts/chart_columns.hpp"

namespace moat {

std::optional<Chart> energy_chart(const CaseResult& result) {
  const auto energies = [&](const EnergyColumn& column) {
    return columns_of(result.histories, std::string{column.name} + "_energy");
  };
  const std::vector<const Column*> times = columns_of(result.histories, "time");
  if (times.empty() || times.front()->values.size() < 2) return std::nullopt;
  const std::vector<double>& time = times.front()->values;
  Chart chart;
  chart.title = "Energy";
  chart.x_label = "time [s]";
  chart.y_label = axis_label("energy", "J");
  std::vector<double> below(time.size(), 0.0), input;
  // Energies that only grow lie at the bottom, those that come and go on top.
  for (double EnergyBalance::*const part :
       {&EnergyBalance::hysteretic, &EnergyBalance::viscous, &EnergyBalance::impact, &EnergyBalance::friction,
        &EnergyBalance::strain, &EnergyBalance::kinetic, &EnergyBalance::input}) {
    for (const EnergyColumn& column : energy_columns(result.energy.in_plan)) {
      if (column.value != part || energies(column).empty()) continue;
      const std::vector<double> values = in_engineering_unit(*energies(column).front());
      if (part == &EnergyBalance::input) {
        chart.series.push_back({.name = column.name, .x = time, .y = values, .colour = 6});
        return chart;
      }
      Series band{.name = column.name, .x = time, .y = below, .style = Series::Style::band};
      for (std::size_t i = 0; i < below.size(); ++i) below[i] += values[i];
      for (std::size_t i = time.size(); i-- > 0;) {
        band.x.push_back(time[i]);
        band.y.push_back(below[i]);
      }
      chart.series.push_back(std::move(band));
    }
  }
  return std::nullopt;  // no input
}

}  // namespace moat
