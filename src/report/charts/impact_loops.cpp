#include "report/charts/impact_loops.hpp"

#include <algorithm>

#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"
#include "report/charts/chart_columns.hpp"

namespace moat {
namespace {

Chart loop_of(const Impact& impact) {
  const double length = engineering_unit("m").per_si, force = engineering_unit("N").per_si;
  Chart chart;
  chart.title = title_of(impact);
  chart.x_label = axis_label("indentation", "m");
  chart.y_label = axis_label("impact force", "N");
  Series series{.name = "", .x = impact.loop.indentation, .y = impact.loop.force};
  for (double& each : series.x) each *= length;
  for (double& each : series.y) each *= force;
  chart.series.push_back(std::move(series));
  return chart;
}

}  // namespace

std::string title_of(const Impact& impact) { return to_fixed(impact.start, 3) + " s, " + impact.where; }

std::vector<Chart> impact_loops(const std::vector<Impact>& impacts) {
  std::vector<const Impact*> drawn;
  for (const Impact& impact : impacts)
    if (impact.loop.force.size() > 1) drawn.push_back(&impact);
  if (drawn.size() > most_impact_loops) {
    std::ranges::stable_sort(drawn,
                             [](const Impact* a, const Impact* b) { return a->largest_force > b->largest_force; });
    drawn.resize(most_impact_loops);
    std::ranges::stable_sort(drawn, {}, [](const Impact* impact) { return impact->start; });
  }
  std::vector<Chart> charts;
  for (const Impact* impact : drawn) charts.push_back(loop_of(*impact));
  return charts;
}

}  // namespace moat
