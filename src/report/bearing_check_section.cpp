#include <algorithm>
#include <cmath>

#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"
#include "report/html.hpp"
#include "report/sections.hpp"

namespace moat::html {
namespace {

// For every type and check, finds the bearing with the largest ratio, or demand where it is not judged.
std::vector<BearingCheckRow> worst_of_types(const std::vector<BearingCheckRow>& rows) {
  std::vector<BearingCheckRow> worst;
  for (const BearingCheckRow& row : rows) {
    const auto same = std::ranges::find_if(worst, [&](const BearingCheckRow& other) {
      return other.type == row.type && other.demand.check == row.demand.check;
    });
    if (same == worst.end())
      worst.push_back(row);
    else if (row.demand.size() > same->demand.size())
      *same = row;
  }
  return worst;
}

std::string short_cell(double value) {
  return "<td class=\"number\">" + (std::isnan(value) ? "-" : to_significant(value, 4)) + "</td>";
}

}  // namespace

std::string bearing_check_section(const CaseResult& result) {
  if (result.bearing_checks.empty()) return "";
  std::string html =
      "<h2>Checks of bearings</h2>\n<p>Demand over capacity, each at one instant, of the bearing with the largest "
      "ratio "
      "of its type; bearing_checks.csv has all bearings. Limits of codes are cited from memory: compare them with the "
      "edition that governs.</p>\n<div class=\"wide\"><table class=\"dense\">\n<tr><th scope=\"col\">Type</th>"
      "<th scope=\"col\">Check</th><th scope=\"col\">Bearing</th><th class=\"number\" scope=\"col\">Demand</th>"
      "<th class=\"number\" scope=\"col\">Capacity</th><th scope=\"col\"></th>"
      "<th class=\"number\" scope=\"col\">Ratio</th><th class=\"number\" scope=\"col\">at s</th>"
      "<th scope=\"col\">Capacity from</th></tr>\n";
  for (const auto& [bearing, type, demand] : worst_of_types(result.bearing_checks)) {
    const EngineeringUnit unit = engineering_unit(demand.unit);
    html += (demand.ratio() > 1.0 ? "<tr class=\"unsettled\">" : "<tr>") + cell(type) +
            cell(capitalised(std::string{demand.check})) + cell(bearing) + short_cell(unit.per_si * demand.demand) +
            short_cell(unit.per_si * demand.capacity) +
            cell(unit.symbol == "1" ? "" : with_raised_digits(unit.symbol)) + short_cell(demand.ratio()) +
            "<td class=\"number\">" + to_fixed(demand.time, 3) + "</td>" + cell(std::string{demand.source}) + "</tr>\n";
  }
  return html + "</table></div>\n";
}

}  // namespace moat::html
