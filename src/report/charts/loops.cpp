#include "report/charts/result_charts.hpp"

#include <algorithm>

#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"
#include "report/charts/chart_columns.hpp"

namespace moat {
namespace {

Chart empty_chart(std::string title) {
  return {.title = std::move(title), .x_label = axis_label("deformation", "m"), .y_label = axis_label("force", "N")};
}

// Adds the force over the deformation of an isolator, both of one component in plan.
void add_loop(Chart& chart, const Table& table, const std::string& name, const std::string& isolator,
              const std::string& component = "") {
  const Column *deformation = column_of(table, "isolator_deformation" + component, isolator),
               *force = column_of(table, "isolator_force" + component, isolator);
  if (deformation != nullptr && force != nullptr)
    chart.series.push_back({name, in_engineering_unit(*deformation), in_engineering_unit(*force)});
}

// One for the bearing of each building with the largest deformation, which the first table of a report names.
std::vector<Chart> loops_in_plan(const CaseResult& result) {
  std::vector<Chart> charts;
  for (const BuildingParts& building : result.buildings) {
    const Peak* widest = nullptr;
    for (const Peak& peak : result.peaks)
      if (peak.quantity == "isolator_deformation" &&
          std::ranges::find(building.isolators, peak.where) != building.isolators.end() &&
          (widest == nullptr || peak.magnitude() > widest->magnitude()))
        widest = &peak;
    if (charts.size() == most_charted_buildings || widest == nullptr) continue;
    Chart chart = empty_chart("Loops of " + widest->where);
    for (const std::string component : {"x", "y"})
      add_loop(chart, result.histories, "along " + component, widest->where, "_" + component);
    if (!chart.series.empty()) charts.push_back(std::move(chart));
  }
  return charts;
}

Chart loop_of(const Impact& impact) {
  Series series{.name = "", .x = impact.loop.indentation, .y = impact.loop.force};
  for (double& each : series.x) each *= engineering_unit("m").per_si;
  for (double& each : series.y) each *= engineering_unit("N").per_si;
  return {.title = title_of(impact),
          .x_label = axis_label("indentation", "m"),
          .y_label = axis_label("impact force", "N"),
          .series = {std::move(series)}};
}

}  // namespace

std::vector<Chart> isolator_loops(const CaseResult& result) {
  const Table& table = result.histories;
  require_equal_lengths(table);
  if (!result.model.diaphragms.empty()) return loops_in_plan(result);
  std::vector<Chart> charts;
  for (const BuildingParts& building : result.buildings) {
    if (charts.size() == most_charted_buildings) break;
    Chart chart = empty_chart(building.name.empty() ? "Loops of the isolators" : "Isolators of " + building.name);
    for (const std::string& isolator : building.isolators) add_loop(chart, table, isolator, isolator);
    if (!chart.series.empty()) charts.push_back(std::move(chart));
  }
  return charts;
}

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

std::vector<Chart> orbit_charts(const CaseResult& result) {
  const double per_metre = engineering_unit("m").per_si;
  std::vector<Chart> charts;
  for (const DiaphragmFacts& base : result.model.diaphragms) {
    const Column *x = column_of(result.histories, "displacement_x", base.name),
                 *y = column_of(result.histories, "displacement_y", base.name),
                 *rotation = column_of(result.histories, "rotation", base.name);
    if (!base.is_base || x == nullptr || y == nullptr || rotation == nullptr) continue;
    Chart chart{.title = "Orbit of " + base.name,
                .x_label = axis_label("displacement along x", "m"),
                .y_label = axis_label("displacement along y", "m"),
                .series = {}};
    const auto add = [&](std::string name, PlanVector point) {
      const PlanVector turned = turned_left(point - base.centre_of_mass);
      Series series{.name = std::move(name), .x = {}, .y = {}};
      for (std::size_t row = 0; row < x->values.size(); ++row) {
        series.x.push_back(per_metre * (x->values[row] + rotation->values[row] * turned.x));
        series.y.push_back(per_metre * (y->values[row] + rotation->values[row] * turned.y));
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
