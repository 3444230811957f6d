#include "report/charts/orbit_charts.hpp"

#include "output/files/engineering_unit.hpp"
#include "report/charts/chart_columns.hpp"
#include "report/charts/orbit.hpp"

namespace moat {

std::vector<Chart> orbit_charts(const CaseResult& result) {
  const double per_metre = engineering_unit("m").per_si;
  std::vector<Chart> charts;
  for (const DiaphragmFacts& base : result.model.diaphragms) {
    const std::optional<Orbit> orbit = base.is_base ? orbit_of(base, result.histories) : std::nullopt;
    if (!orbit) continue;
    Chart chart;
    chart.title = "Orbit of " + base.name;
    chart.x_label = axis_label("displacement along x", "m");
    chart.y_label = axis_label("displacement along y", "m");
    const auto add = [&](std::string name, PlanVector point) {
      Series series{.name = std::move(name), .x = {}, .y = {}};
      for (std::size_t row = 0; row < orbit->rows(); ++row) {
        const PlanVector displacement = orbit->displacement(row, point - base.centre_of_mass);
        series.x.push_back(per_metre * displacement.x);
        series.y.push_back(per_metre * displacement.y);
      }
      chart.series.push_back(std::move(series));
    };
    add("centre of mass", base.centre_of_mass);
    for (std::size_t i = 0; i < base.outline.size(); ++i) add("corner " + std::to_string(i + 1), base.outline[i]);
    charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace moat
