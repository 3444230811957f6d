#include "report/sections.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"
#include "output/peaks/peak_groups.hpp"
#include "report/html.hpp"

namespace moat::html {
namespace {

// A table of more bearings is closed until the reader opens it.
constexpr std::size_t most_open_bearings = 12;

// Digits that are not there still take their room, so that decimal points stand below each other.
std::string value_of(const PeakRow& peak) {
  return peak.missing.empty() ? peak.value : peak.value + "<span class=\"missing\">" + peak.missing + "</span>";
}

std::string error_bar_note(const ErrorBars& bars) {
  if (!bars.checked) return bars.companion.empty() ? "" : "<p>" + escaped(bars.companion) + "</p>\n";
  return "<p>&plusmn; is the estimated numerical error. " + escaped(error_bar_method) +
         " Second run: " + escaped(bars.companion) + " It took " +
         std::to_string(bars.companion_solver.accepted_steps) + " steps and " +
         number_with_unit(bars.companion_solver.cpu_seconds, "s") + " of processor time, and has " +
         std::to_string(bars.companion_impacts) + " impacts.</p>\n";
}

// `last` heads the column behind the times, unless it is empty.
std::string table_of(const PeakGroup& group, bool with_errors, std::string_view last, const ErrorBars& bars) {
  std::string html = "<table>\n<tr class=\"group\"><th scope=\"col\">" + escaped(capitalised(group.quantity)) +
                     "</th><th class=\"number\" scope=\"col\">" + escaped(with_raised_digits(group.unit)) + "</th>";
  if (with_errors) html += "<th scope=\"col\">numerical error</th>";
  if (!group.second_unit.empty()) html += "<th class=\"number\" scope=\"col\">" + group.second_unit + "</th>";
  const bool has_last = std::ranges::any_of(group.rows, [](const PeakRow& peak) { return !peak.side.empty(); });
  html += "<th class=\"number\" scope=\"col\">at s</th><th scope=\"col\">" + std::string{has_last ? last : ""} +
          "</th></tr>\n";
  for (const PeakRow& peak : group.rows) {
    const bool unsettled = std::ranges::any_of(bars.unsettled_peaks, [&](const Peak& each) {
      return in_words(each.quantity) == group.quantity && each.where == peak.where;
    });
    html += std::string{unsettled ? "<tr class=\"unsettled\">" : "<tr>"} + "<td>" + escaped(peak.where) +
            "</td><td class=\"number\">" + value_of(peak) + "</td>";
    if (with_errors) html += "<td class=\"error\">" + (peak.error.empty() ? "" : "&plusmn; " + peak.error) + "</td>";
    if (!group.second_unit.empty()) html += "<td class=\"number\">" + peak.second + "</td>";
    html += "<td class=\"number\">" + peak.time + "</td><td>" + escaped(peak.side) + "</td></tr>\n";
  }
  return html + "</table>\n";
}

// Keeps the rows of a group with the largest sizes, in their order; returns whether it had more.
bool shorten(PeakGroup& group) {
  if (group.rows.size() <= most_places) return false;
  std::vector<double> sizes;
  for (const PeakRow& row : group.rows) sizes.push_back(row.size);
  std::ranges::nth_element(sizes, sizes.begin() + (most_places - 1), std::ranges::greater{});
  std::erase_if(group.rows, [&](const PeakRow& row) { return row.size < sizes[most_places - 1]; });
  group.rows.resize(most_places);
  return true;
}

}  // namespace

std::string peak_section(const CaseResult& result) {
  const std::set<std::string> constant = constant_quantities(result.histories);
  bool all_shown = true;
  const std::vector<PeakGroup> groups =
      groups_of_tables(result, [&](PeakGroup& group) { all_shown = !shorten(group) && all_shown; });
  std::string html =
      "<h2>Peaks</h2>\n" + error_bar_note(result.error_bars) +
      (result.model.diaphragms.empty() ? "<p>Positive to the right"
                                       : "<p>x is positive to the right, y up in plan, rotations counter-clockwise") +
      "; forces and deformations of gaps are positive in compression.";
  if (!all_shown)
    html += " Shown are the largest " + std::to_string(most_places) +
            " places of each quantity; summary.json has all " + std::to_string(result.peaks.size()) + " peaks.";
  if (!constant.empty()) html += " Not listed, because it never changes: ";
  for (const std::string& quantity : constant)
    html += (quantity == *constant.begin() ? "" : ", ") + escaped(in_words(quantity));
  html += (constant.empty() ? "</p>" : ".</p>") + std::string{"\n<div class=\"columns wide\">\n"};
  for (const PeakGroup& group : groups) html += table_of(group, result.error_bars.checked, "side", result.error_bars);
  return html + "</div>\n";
}

std::string bearing_section(const CaseResult& result) {
  const auto bearings = single_bearings(result.model);
  struct Row {
    const ElementFacts* bearing;
    Peak deformation, force;
  };
  std::map<std::string, Row> by_name;
  for (const Peak& peak : result.peaks)
    if (const auto found = bearings.find(peak.where); found != bearings.end()) {
      Row& row = by_name[peak.where];
      row.bearing = found->second;
      if (peak.quantity == "isolator_deformation") row.deformation = peak;
      if (peak.quantity == "isolator_force") row.force = peak;
    }
  if (by_name.empty()) return "";
  std::vector<Row> rows;
  for (const ElementFacts& element : result.model.elements)
    if (const auto found = by_name.find(element.name); found != by_name.end()) rows.push_back(found->second);
  std::ranges::stable_sort(rows, std::ranges::greater{}, [](const Row& row) { return row.deformation.magnitude(); });
  const std::size_t all = rows.size();
  rows.resize(std::min(all, most_places));
  std::vector<Peak> deformations, forces;
  for (const Row& row : rows) {
    deformations.push_back(row.deformation);
    forces.push_back(row.force);
  }
  const PeakGroup deformation = group_peaks(deformations).front(), force = group_peaks(forces).front();
  const auto cells = [](const PeakRow& row) {
    return "<td class=\"number\">" + value_of(row) + "</td><td class=\"error\">" +
           (row.error.empty() ? "" : "&plusmn; " + row.error) + "</td>";
  };
  std::string html = "<details" + std::string{all <= most_open_bearings ? " open" : ""} + "><summary>" +
                     std::to_string(all) + " bearings, the largest deformation first</summary>\n";
  html +=
      "<div class=\"wide\"><table class=\"dense\">\n<tr><th scope=\"col\">Bearing</th><th scope=\"col\">Type</th>"
      "<th class=\"number\" scope=\"col\">x [m]</th><th class=\"number\" scope=\"col\">y [m]</th>"
      "<th class=\"number\" scope=\"col\">Deformation [cm]</th><th scope=\"col\">numerical error</th><th "
      "class=\"number\" scope=\"col\">at s</th>"
      "<th class=\"number\" scope=\"col\">Force [kN]</th><th scope=\"col\">numerical error</th></tr>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ElementFacts& bearing = *rows[i].bearing;
    const PlanVector at = bearing.plan_places ? bearing.plan_places->second : PlanVector{};
    html += "<tr><td>" + escaped(bearing.name) + "</td><td>" + escaped(bearing.place + ", " + bearing.law) +
            "</td><td class=\"number\">" + to_significant(at.x, 5) + "</td><td class=\"number\">" +
            to_significant(at.y, 5) + "</td>" + cells(deformation.rows[i]) + "<td class=\"number\">" +
            deformation.rows[i].time + "</td>" + cells(force.rows[i]) + "</tr>\n";
  }
  html += "</table></div>\n";
  if (all > rows.size()) html += "<p>... and " + std::to_string(all - rows.size()) + " more in peaks.csv.</p>\n";
  return html + "</details>\n";
}

std::string clearance_section(const CaseResult& result) {
  if (result.clearances.empty()) return "";
  PeakGroup least = clearance_group(result.clearances);
  const bool all_shown = least.rows.size() <= most_places;
  if (!all_shown) {
    std::ranges::stable_sort(least.rows, {}, &PeakRow::size);
    least.rows.resize(most_places);
  }
  return "<h2>Clearances</h2>\n<p>The smallest opening of every gap" +
         (all_shown ? ""
                    : ", of the " + std::to_string(most_places) + " narrowest of " +
                          std::to_string(result.clearances.size())) +
         ". Negative: the two sides indented each other by so much.</p>\n<div class=\"wide\">\n" +
         table_of(least, result.error_bars.checked, "at rest", {}) + "</div>\n";
}

std::string section_at_the_end(const CaseResult& result) {
  std::vector<PeakGroup> isolators = group_peaks(residual_displacements(result.histories));
  if (isolators.empty()) return "";
  shorten(isolators.front());
  return "<h2>At the end</h2>\n<p>The residual displacement of isolators: their deformation when the analysis ends or, "
         "where they still move, the mean of the last two turns. It needs free vibration of two periods behind the "
         "motion.</p>\n<div class=\"wide\">\n" +
         table_of(isolators.front(), false, "", {}) + "</div>\n";
}

}  // namespace moat::html
