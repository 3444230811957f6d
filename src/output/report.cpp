#include "output/report.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "output/chart.hpp"
#include "output/engineering_unit.hpp"
#include "output/file_io.hpp"
#include "output/impact_columns.hpp"
#include "output/peak_groups.hpp"
#include "output/result_charts.hpp"
#include "output/results_folder.hpp"

namespace moat {
namespace {

constexpr std::string_view style = R"(
body { font: 15px/1.5 Arial, Helvetica, "Liberation Sans", sans-serif; color: #222; max-width: 1040px;
       margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.6em; margin-bottom: .2em; }
h2 { font-size: 1.2em; margin-top: 2em; border-bottom: 1px solid #ccc; padding-bottom: .2em; }
table { border-collapse: collapse; margin: .8em 0; }
th, td { padding: .2em .9em; text-align: left; border-bottom: 1px solid #e4e4e4; }
th { background: #f3f5f7; }
tr.group th { background: none; padding-top: .9em; border-bottom: 1px solid #888; }
td:first-child { white-space: nowrap; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
td.error { padding-left: 0; white-space: nowrap; font-variant-numeric: tabular-nums; }
tr.group th:nth-child(3):empty { padding: 0; }
tr.unsettled td { background: #fdf0e0; }
.missing { visibility: hidden; }
.sensitive { background: #fdf0e0; border-left: 4px solid #c55a11; padding: .5em .9em; }
svg { max-width: 100%; height: auto; display: block; }
)";

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string row(std::string_view name, std::string_view value) {
  return "<tr><td>" + escaped(name) + "</td><td class=\"number\">" + escaped(value) + "</td></tr>\n";
}

std::string number_with_unit(double value_in_si, std::string_view si_symbol) {
  const EngineeringUnit unit = engineering_unit(si_symbol);
  const double value = unit.per_si * value_in_si;
  return with_decimals(value, decimals_for(std::abs(value))) + " " + with_raised_digits(unit.symbol);
}

std::string motion_section(const CaseResult& result) {
  std::string html = "<h2>Ground motion</h2>\n<table>\n";
  html += row("Name", result.motion.name);
  html += row("Peak acceleration", number_with_unit(result.motion.peak_acceleration, "m/s^2"));
  html += row("Peak velocity", number_with_unit(result.motion.peak_velocity, "m/s"));
  html += row("Time step", number_with_unit(result.motion.time_step, "s"));
  html += row("Duration", number_with_unit(result.motion.duration, "s"));
  html += "</table>\n";
  if (result.periods.empty()) return html;
  html += "<h2>Periods</h2>\n<table>\n";
  for (const NamedPeriod& period : result.periods) html += row(period.name, number_with_unit(period.value, "s"));
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

std::string peak_section(const CaseResult& result) {
  std::string html = "<h2>Peaks</h2>\n" + error_bar_note(result) + "<table>\n";
  const bool with_errors = result.error_bars.checked;
  for (const PeakGroup& group : group_peaks(result.peaks)) {
    html += "<tr class=\"group\"><th>" + escaped(capitalised(group.quantity)) + "</th><th class=\"number\">" +
            escaped(with_raised_digits(group.unit)) + "</th>";
    if (with_errors) html += "<th></th>";
    html += "<th class=\"number\">at s</th></tr>\n";
    for (const PeakRow& peak : group.rows) {
      const bool unsettled = std::ranges::any_of(result.error_bars.unsettled, [&](const Peak& each) {
        return in_words(each.quantity) == group.quantity && each.where == peak.where;
      });
      html += std::string{unsettled ? "<tr class=\"unsettled\">" : "<tr>"} + "<td>" + escaped(peak.where) +
              "</td><td class=\"number\">" + peak_value(peak) + "</td>";
      if (with_errors) html += "<td class=\"error\">" + (peak.error.empty() ? "" : "&plusmn; " + peak.error) + "</td>";
      html += "<td class=\"number\">" + peak.time + "</td></tr>\n";
    }
  }
  return html + "</table>\n";
}

std::string impact_section(const CaseResult& result) {
  std::string html = "<h2>Impacts</h2>\n";
  if (result.impacts.empty()) return html + "<p>No contact.</p>\n";
  html += "<table>\n<tr><th>Where</th>";
  std::vector<int> decimals;
  for (const ImpactColumn& column : impact_columns) {
    const EngineeringUnit unit = engineering_unit(column.unit);
    html += "<th class=\"number\">" + escaped(capitalised(in_words(column.name)));
    if (unit.symbol != "1") html += " [" + escaped(with_raised_digits(unit.symbol)) + "]";
    html += "</th>";
    double largest = 0.0;
    for (const Impact& impact : result.impacts)
      largest = std::max(largest, std::abs(unit.per_si * (impact.*column.value)));
    decimals.push_back(decimals_for(largest));
  }
  html += "</tr>\n";
  for (const Impact& impact : result.impacts) {
    html += "<tr><td>" + escaped(impact.where) + "</td>";
    for (std::size_t i = 0; i < impact_columns.size(); ++i)
      html += "<td class=\"number\">" +
              with_decimals(engineering_unit(impact_columns[i].unit).per_si * (impact.*impact_columns[i].value),
                            decimals[i]) +
              "</td>";
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string energy_section(const CaseResult& result) {
  const EnergyBalance& energy = result.energy;
  const auto kilojoule = [](double joule) { return number_with_unit(joule, "J"); };
  std::string html = "<h2>Energy</h2>\n<table>\n";
  html += row("Input by the ground", kilojoule(energy.input));
  html += row("Kinetic, at the end", kilojoule(energy.kinetic));
  html += row("Strain, at the end", kilojoule(energy.strain));
  html += row("Dissipated by viscous damping", kilojoule(energy.viscous));
  for (const DissipatedEnergy& group : energy.bearings)
    html += row("Dissipated by hysteresis, " + group.where, kilojoule(group.value));
  for (const DissipatedEnergy& gap : energy.gaps) html += row("Lost in impacts, " + gap.where, kilojoule(gap.value));
  html += row("Residual of the equations", kilojoule(energy.equation_residual));
  html += row("Error of the integration", kilojoule(energy.integration_error));
  if (!energy.worst_element.empty())
    html += row("of this, largest at " + energy.worst_element, kilojoule(energy.worst_element_error));
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
  html += row("Accepted steps", std::to_string(solver.accepted_steps));
  html += row("Rejected steps", std::to_string(solver.rejected_steps));
  html += row("Steps repeated shorter", std::to_string(solver.repeated_steps));
  html += row("Events", std::to_string(solver.events));
  html += row("Solves to land on an event", std::to_string(solver.event_solves));
  html += row("Newton iterations", std::to_string(solver.newton_iterations));
  html += row("Factorisations", std::to_string(solver.factorisations));
  html += row("Processor time", number_with_unit(solver.cpu_seconds, "s"));
  html += "</table>\n<h2>Assumptions</h2>\n<ul>\n";
  for (const std::string& assumption : result.assumptions) html += "<li>" + escaped(assumption) + "</li>\n";
  return html + "</ul>\n";
}

std::string chart_section(const CaseResult& result) {
  std::string html;
  const std::vector<Chart> histories = history_charts(result);
  if (!histories.empty()) html += "<h2>Histories</h2>\n" + svg_text(histories, 1000, 300);
  if (const auto loop = hysteresis_chart(result)) html += "<h2>Hysteresis</h2>\n" + svg_text({*loop}, 700, 440);
  return html;
}

}  // namespace

void write_report_html(const CaseResult& result, const std::filesystem::path& folder) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" +
                     escaped(result.title) + "</title>\n<style>" + std::string{style} + "</style>\n</head>\n<body>\n";
  html += "<h1>" + escaped(result.title) + "</h1>\n";
  html += warning_section(result);
  html += motion_section(result);
  html += peak_section(result);
  html += impact_section(result);
  html += chart_section(result);
  html += energy_section(result);
  html += solver_section(result);
  html += "</body>\n</html>\n";
  write_file(folder / results_file::report, html);
}

}  // namespace moat
