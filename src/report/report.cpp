#include "report/report.hpp"

#include <string>
#include <vector>

#include "output/files/file_io.hpp"
#include "output/files/results_folder.hpp"
#include "output/recorders/energy_columns.hpp"
#include "report/html.hpp"
#include "report/page_data.hpp"
#include "report/sections.hpp"

namespace moat {
namespace {

using html::escaped;
using html::number_row;
using html::number_with_unit;

std::string period_section(const CaseResult& result) {
  if (result.periods.empty()) return "";
  std::string html = "<h2>Periods</h2>\n<table>\n";
  for (const NamedPeriod& period : result.periods) html += number_row(period.name, number_with_unit(period.value, "s"));
  return html + "</table>\n";
}

std::string energy_section(const CaseResult& result, const std::vector<Chart>& charts) {
  static const std::vector<DissipatedEnergy> no_parts;
  const EnergyBalance& energy = result.energy;
  const auto kilojoule = [](double joule) { return number_with_unit(joule, "J"); };
  std::string html = "<h2>Energy</h2>\n" +
                     (charts.empty() ? std::string{} : html::wide_picture(svg_text(charts, 1000, 320))) +
                     "<details><summary>At the end of the run</summary>\n<table>\n";
  for (const EnergyColumn& column : energy_columns(energy.in_plan, energy.weights_change)) {
    html += number_row(column.words, kilojoule(energy.*column.value));
    const bool by_bearing = column.value == &EnergyBalance::hysteretic, by_gap = column.value == &EnergyBalance::impact;
    for (const DissipatedEnergy& part : by_bearing ? energy.bearings : by_gap ? energy.gaps : no_parts)
      if (part.value != 0.0) html += number_row("of this, " + part.where, kilojoule(part.value));
  }
  for (const EnergyColumn& column : energy_errors) html += number_row(column.words, kilojoule(energy.*column.value));
  if (!energy.worst_element.empty())
    html += number_row("Error of the integration, largest at " + energy.worst_element,
                       kilojoule(energy.worst_element_error));
  return html + "</table></details>\n";
}

std::string solver_section(const CaseResult& result) {
  const SolverStatistics& solver = result.solver;
  std::string html = "<h2>Solver</h2>\n<table>\n";
  html += number_row("Accepted steps", std::to_string(solver.accepted_steps));
  html += number_row("Rejected steps", std::to_string(solver.rejected_steps));
  html += number_row("Steps repeated shorter", std::to_string(solver.repeated_steps));
  html += number_row("Events", std::to_string(solver.events));
  html += number_row("Solves to land on an event", std::to_string(solver.event_solves));
  html += number_row("Newton iterations", std::to_string(solver.newton_iterations));
  html += number_row("Factorisations", std::to_string(solver.factorisations));
  html += number_row("Processor time", number_with_unit(solver.cpu_seconds, "s"));
  html += "</table>\n<h2>Assumptions</h2>\n<ul>\n";
  for (const std::string& assumption : result.assumptions) html += "<li>" + escaped(assumption) + "</li>\n";
  return html + "</ul>\n";
}

std::string grid_of(const char* title, const std::vector<Chart>& charts, int height) {
  return charts.empty() ? "" : std::string{"<h2>"} + title + "</h2>\n" + html::chart_grid(charts, 500, height);
}

// One figure for each, which the page's script makes a chart that zooms.
std::string history_section(const std::vector<Chart>& charts) {
  if (charts.empty()) return "";
  std::string html =
      "<h2>Histories</h2>\n<button type=\"button\" id=\"whole-histories\" hidden>Whole histories</button>\n";
  for (std::size_t i = 0; i < charts.size(); ++i)
    html += "<figure data-history=\"" + std::to_string(i) + "\">" + svg_text({charts[i]}, 1000, 300) + "</figure>\n";
  return html;
}

std::string input_section(const CaseResult& result) {
  return "<details><summary>Motion, model, origin, solver, assumptions</summary>\n" +
         html::motion_section(result.motion) + html::model_section(result.model) +
         html::provenance_section(result.provenance) + html::analysis_section(result.analysis) +
         solver_section(result) + "</details>\n";
}

}  // namespace

void write_report_html(const CaseResult& result, const ResultCharts& charts, const std::filesystem::path& folder) {
  const std::string body =
      html::summary_section(result) + html::warning_section(result) + html::drawing_section(result) +
      grid_of("Orbits", charts.orbits, 400) + history_section(charts.histories) +
      grid_of("Largest values over height", charts.floor_profiles, 300) +
      grid_of("Isolators", charts.isolator_loops, 340) + html::bearing_section(result) +
      html::bearing_check_section(result) + html::impact_section(result, charts.impact_loops) +
      html::sensitivity_section(result.contact_sensitivity, charts.sensitivity) +
      energy_section(result, charts.energy) + grid_of("Floor response spectra", charts.floor_spectra, 320) +
      html::peak_section(result) + html::clearance_section(result) + html::section_at_the_end(result) +
      period_section(result) + input_section(result);
  write_file(folder / results_file::report, html::page_with_script(result.title, body, html::page_data(result)));
}

}  // namespace moat
