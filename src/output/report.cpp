#include "output/report.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "output/chart.hpp"
#include "output/energy_columns.hpp"
#include "output/engineering_unit.hpp"
#include "output/file_io.hpp"
#include "output/impact_columns.hpp"
#include "output/peak_groups.hpp"
#include "output/plan_view.hpp"
#include "output/report_html.hpp"
#include "output/report_input.hpp"
#include "output/report_page.hpp"
#include "output/result_charts.hpp"
#include "output/results_folder.hpp"

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

// Digits that are not there still take their room, so that decimal points stand below each other.
std::string peak_value(const PeakRow& peak) {
  return peak.missing.empty() ? peak.value : peak.value + "<span class=\"missing\">" + peak.missing + "</span>";
}

std::string error_bar_note(const CaseResult& result) {
  const ErrorBars& bars = result.error_bars;
  if (!bars.checked) return bars.companion.empty() ? "" : "<p>" + escaped(bars.companion) + "</p>\n";
  std::string html = "<p>&plusmn; is the estimated numerical error. " + escaped(error_bar_method) +
                     " Second run: " + escaped(bars.companion) + " It took " +
                     std::to_string(bars.companion_solver.accepted_steps) + " steps and " +
                     number_with_unit(bars.companion_solver.cpu_seconds, "s") + " of processor time, and has " +
                     std::to_string(bars.companion_impacts) + " impacts.</p>\n";
  if (bars.sensitive)
    html += "<p class=\"sensitive\"><strong>The case is sensitive:</strong> " + escaped(bars.reason) + "." +
            (bars.unsettled.empty() ? "" : " Peaks that are not settled are shaded.") + "</p>\n";
  return html;
}

// A table of peaks or clearances; `last` heads the column behind the times.
std::string group_rows(const PeakGroup& group, bool with_errors, std::string_view last, const ErrorBars& bars) {
  std::string html = "<tr class=\"group\"><th>" + escaped(capitalised(group.quantity)) + "</th><th class=\"number\">" +
                     escaped(with_raised_digits(group.unit)) + "</th>";
  if (with_errors) html += "<th></th>";
  html += "<th class=\"number\">at s</th><th>" + std::string{last} + "</th></tr>\n";
  for (const PeakRow& peak : group.rows) {
    const bool unsettled = std::ranges::any_of(bars.unsettled, [&](const Peak& each) {
      return in_words(each.quantity) == group.quantity && each.where == peak.where;
    });
    html += std::string{unsettled ? "<tr class=\"unsettled\">" : "<tr>"} + "<td>" + escaped(peak.where) +
            "</td><td class=\"number\">" + peak_value(peak) + "</td>";
    if (with_errors) html += "<td class=\"error\">" + (peak.error.empty() ? "" : "&plusmn; " + peak.error) + "</td>";
    html += "<td class=\"number\">" + peak.time + "</td><td>" + escaped(peak.side) + "</td></tr>\n";
  }
  return html;
}

std::string peak_section(const CaseResult& result) {
  std::string html =
      "<h2>Peaks</h2>\n" + error_bar_note(result) +
      "<p>Positive to the right; forces and deformations of gaps are positive in compression.</p>\n<table>\n";
  for (const PeakGroup& group : group_peaks(result.peaks))
    html += group_rows(group, result.error_bars.checked, "side", result.error_bars);
  return html + "</table>\n";
}

std::string clearance_section(const CaseResult& result) {
  if (result.clearances.empty()) return "";
  return "<h2>Clearances</h2>\n<p>The smallest opening of every gap. Negative: the two sides indented each other by so "
         "much.</p>\n<table>\n" +
         group_rows(clearance_group(result.clearances), result.error_bars.checked, "at rest", {}) + "</table>\n";
}

std::string impact_section(const CaseResult& result) {
  std::string html = "<h2>Impacts</h2>\n";
  if (result.impacts.empty()) return html + "<p>No contact.</p>\n";
  html += "<table>\n<tr><th>Where</th>";
  std::vector<int> decimals;
  const std::vector<ImpactColumn> columns = columns_of(result.impacts);
  for (const ImpactColumn& column : columns) {
    const EngineeringUnit unit = engineering_unit(column.unit);
    html += "<th class=\"number\">" + escaped(capitalised(in_words(column.name)));
    if (unit.symbol != "1") html += " [" + escaped(with_raised_digits(unit.symbol)) + "]";
    html += "</th>";
    double largest = 0.0;
    for (const Impact& impact : result.impacts)
      largest = std::max(largest, std::abs(unit.per_si * (impact.*column.value)));
    decimals.push_back(std::max(decimals_for(largest), column.least_decimals));
  }
  html += "</tr>\n";
  for (const Impact& impact : result.impacts) {
    html += "<tr><td>" + escaped(impact.where) + "</td>";
    for (std::size_t i = 0; i < columns.size(); ++i)
      html += "<td class=\"number\">" +
              with_decimals(engineering_unit(columns[i].unit).per_si * (impact.*columns[i].value), decimals[i]) +
              "</td>";
    html += "</tr>\n";
  }
  return html +
         "</table>\n<p>Rebound ratio: speed of separation over speed of approach as it happened, with the building "
         "pushing; "
         "it may exceed 1. Restitution: the same ratio of the law alone, in free flight.</p>\n";
}

std::string energy_section(const CaseResult& result) {
  static const std::vector<DissipatedEnergy> no_parts;
  const EnergyBalance& energy = result.energy;
  const auto kilojoule = [](double joule) { return number_with_unit(joule, "J"); };
  std::string html = "<h2>Energy</h2>\n<table>\n";
  for (const EnergyColumn& column : energy_columns(energy.in_plan)) {
    html += number_row(column.words, kilojoule(energy.*column.value));
    const bool by_bearing = column.value == &EnergyBalance::hysteretic, by_gap = column.value == &EnergyBalance::impact;
    for (const DissipatedEnergy& part : by_bearing ? energy.bearings : by_gap ? energy.gaps : no_parts)
      html += number_row("of this, " + part.where, kilojoule(part.value));
  }
  for (const EnergyColumn& column : energy_errors) html += number_row(column.words, kilojoule(energy.*column.value));
  if (!energy.worst_element.empty())
    html += number_row("Error of the integration, largest at " + energy.worst_element,
                       kilojoule(energy.worst_element_error));
  return html + "</table>\n";
}

std::string warning_section(const CaseResult& result) {
  if (result.warnings.empty()) return "";
  std::string html = "<h2>Warnings</h2>\n<ul>\n";
  for (const std::string& warning : result.warnings) html += "<li>" + escaped(warning) + "</li>\n";
  return html + "</ul>\n";
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

std::string chart_section(const CaseResult& result) {
  std::string html;
  for (const std::string& view : plan_views(result)) html += "<h2>Plan</h2>\n" + view;
  const std::vector<Chart> histories = history_charts(result);
  if (!histories.empty()) html += "<h2>Histories</h2>\n" + svg_text(histories, 1000, 300);
  if (const auto loop = hysteresis_chart(result)) html += "<h2>Hysteresis</h2>\n" + svg_text({*loop}, 700, 440);
  return html;
}

}  // namespace

void write_report_html(const CaseResult& result, const std::filesystem::path& folder) {
  std::string page = warning_section(result);
  page += html::motion_section(result.motion);
  page += period_section(result);
  page += peak_section(result);
  page += clearance_section(result);
  page += impact_section(result);
  page += chart_section(result);
  page += energy_section(result);
  page += html::model_section(result.model);
  page += html::provenance_section(result.provenance);
  page += solver_section(result);
  write_file(folder / results_file::report, html::page(result.title, page));
}

}  // namespace moat
