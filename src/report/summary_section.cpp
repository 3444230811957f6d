#include "report/sections.hpp"

#include <algorithm>
#include <string_view>

#include "base/text/number_format.hpp"
#include "output/files/building_rows.hpp"
#include "output/files/engineering_unit.hpp"
#include "output/peaks/peak_groups.hpp"
#include "report/html.hpp"

namespace moat::html {
namespace {

std::string card(std::string_view name, const std::string& value, const std::string& where, bool unsettled = false) {
  return std::string{"<div class=\"card"} + (unsettled ? " unsettled" : "") + "\"><div class=\"name\">" +
         escaped(name) + "</div><div class=\"value\">" + value + "</div><div class=\"where\">" + escaped(where) +
         "</div></div>\n";
}

std::string force_card(const CaseResult& result) {
  const Peak* largest = nullptr;
  for (const Peak& peak : result.peaks)
    if (peak.quantity == "impact_force" && (largest == nullptr || peak.magnitude() > largest->magnitude()))
      largest = &peak;
  if (largest == nullptr || largest->value == 0.0) return "";
  const bool unsettled = std::ranges::any_of(result.error_bars.unsettled_peaks, [&](const Peak& each) {
    return each.quantity == largest->quantity && each.where == largest->where;
  });
  const PeakGroup group = group_peaks({*largest}).front();
  const PeakRow& row = group.rows.front();
  return card("Largest impact force",
              escaped(row.value) + (row.error.empty() ? "" : " <small>&plusmn; " + escaped(row.error) + "</small>") +
                  " <small>" + escaped(group.unit) + "</small>",
              largest->where + " at " + to_fixed(largest->time, 3) + " s", unsettled);
}

// "13.36 +- 0.02 m/s^2" as a page shows it.
std::string with_signs(const std::string& text) {
  std::string html = escaped(with_raised_digits(text));
  const std::size_t at = html.find("+-");
  return at == std::string::npos ? html : html.replace(at, 2, "&plusmn;");
}

std::string table_of(const BuildingTable& table) {
  if (table.headings.empty()) return "";
  std::string html = "<div class=\"wide\"><table class=\"buildings\">\n<tr><th scope=\"col\"></th>";
  for (const std::string& heading : table.headings) html += "<th scope=\"col\">" + capitalised(heading) + "</th>";
  html += "</tr>\n";
  for (const BuildingTable::Row& row : table.rows) {
    html += "<tr><th scope=\"row\">" + escaped(row.name) + "</th>";
    for (const BuildingCell& cell : row.cells)
      html += std::string{"<td"} + (cell.unsettled ? " class=\"unsettled\"" : "") + "><div class=\"value\">" +
              (cell.value.empty() ? "-" : with_signs(cell.value)) + "</div>" +
              (cell.more.empty() ? "" : "<div>" + with_signs(cell.more) + "</div>") +
              (cell.where.empty() ? "" : "<div class=\"where\">" + escaped(cell.where) + "</div>") + "</td>";
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string energy_card(const EnergyBalance& energy) {
  const double scale = std::max(energy.largest_input, energy.largest_kinetic);
  if (!(scale > 0.0)) return "";
  return card("Error of the energy balance", to_significant(100.0 * energy.error_share(), 2) + " <small>%</small>",
              std::string{"of the largest "} + (scale > energy.largest_input ? "kinetic energy, " : "input, ") +
                  number_with_unit(scale, "J"));
}

}  // namespace

std::string summary_section(const CaseResult& result) {
  std::string html = "<p class=\"subtitle\">" + escaped(result.motion.name) + ", peak acceleration " +
                     number_with_unit(result.motion.peak_acceleration, "m/s^2") + ", " +
                     number_with_unit(result.motion.duration, "s");
  if (!result.model.nodes.empty())
    html += ". " + std::to_string(result.model.nodes.size()) + " degrees of freedom, " +
            std::to_string(result.model.elements.size()) + " elements";
  html += ".</p>\n" + table_of(building_table(result)) + "<div class=\"cards\">\n" + force_card(result);
  html += card("Impacts", std::to_string(result.impacts.size()),
               result.impacts.empty() ? "no contact" : "first at " + to_fixed(result.impacts.front().start, 3) + " s");
  html += energy_card(result.energy) + "</div>\n";
  const bool has_errors = html.find("&plusmn;") != std::string::npos;
  return html + (has_errors ? "<p class=\"subtitle\">&plusmn; numerical error, not that of the model.</p>\n" : "");
}

std::string warning_section(const CaseResult& result) {
  std::string html;
  if (result.error_bars.unsettled)
    html += "<p class=\"notice\"><strong>The case is not settled:</strong> " + escaped(result.error_bars.reason) + "." +
            (result.error_bars.unsettled_peaks.empty() ? "" : " Peaks that are not settled are shaded.") + "</p>\n";
  if (result.warnings.empty()) return html;
  html += "<div class=\"notice\"><strong>Warnings</strong>\n<ul>\n";
  for (const std::string& warning : result.warnings) html += "<li>" + escaped(warning) + "</li>\n";
  return html + "</ul></div>\n";
}

}  // namespace moat::html
