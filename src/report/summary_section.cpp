#include "report/sections.hpp"

#include <algorithm>
#include <string_view>

#include "base/text/number_format.hpp"
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

// A value with its error and unit.
std::string value_of(const PeakGroup& group) {
  const PeakRow& row = group.rows.front();
  return escaped(row.value) + (row.error.empty() ? "" : " <small>&plusmn; " + escaped(row.error) + "</small>") +
         " <small>" + escaped(with_raised_digits(group.unit)) + "</small>";
}

std::string peak_card(const CaseResult& result, std::string_view quantity) {
  const Peak* largest = nullptr;
  for (const Peak& peak : result.peaks)
    if (peak.quantity == quantity && (largest == nullptr || peak.magnitude() > largest->magnitude())) largest = &peak;
  if (largest == nullptr) return "";
  const bool unsettled = std::ranges::any_of(result.error_bars.unsettled, [&](const Peak& each) {
    return each.quantity == largest->quantity && each.where == largest->where;
  });
  return card("Largest " + in_words(quantity), value_of(group_peaks({*largest}).front()),
              largest->where + " at " + to_fixed(largest->time, 3) + " s", unsettled);
}

std::string clearance_card(const CaseResult& result) {
  const auto least = std::ranges::min_element(result.clearances, {}, &GapClearance::left);
  if (least == result.clearances.end()) return "";
  const PeakGroup group = clearance_group({*least});
  return card("Smallest clearance left", value_of(group), least->where + ", " + group.rows.front().side);
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
  const bool in_plan = !result.model.diaphragms.empty();
  std::string html = "<p class=\"subtitle\">" + escaped(result.motion.name) + ", peak acceleration " +
                     number_with_unit(result.motion.peak_acceleration, "m/s^2") + ", " +
                     number_with_unit(result.motion.duration, "s");
  if (!result.model.nodes.empty())
    html += ". " + std::to_string(result.model.nodes.size()) + " degrees of freedom, " +
            std::to_string(result.model.elements.size()) + " elements";
  html += ".</p>\n<div class=\"cards\">\n";
  if (in_plan)
    for (const char* quantity : {"corner_displacement", "corner_drift", "corner_acceleration"})
      html += peak_card(result, quantity);
  else
    for (const char* quantity : {"displacement", "drift", "absolute_acceleration"}) html += peak_card(result, quantity);
  for (const char* quantity : {"isolator_deformation", "impact_force"}) html += peak_card(result, quantity);
  html += clearance_card(result);
  html += card("Impacts", std::to_string(result.impacts.size()),
               result.impacts.empty() ? "no contact" : "first at " + to_fixed(result.impacts.front().start, 3) + " s");
  return html + energy_card(result.energy) + "</div>\n";
}

std::string warning_section(const CaseResult& result) {
  std::string html;
  if (result.error_bars.sensitive)
    html += "<p class=\"notice\"><strong>The case is sensitive:</strong> " + escaped(result.error_bars.reason) + "." +
            (result.error_bars.unsettled.empty() ? "" : " Peaks that are not settled are shaded.") + "</p>\n";
  if (result.warnings.empty()) return html;
  html += "<div class=\"notice\"><strong>Warnings</strong>\n<ul>\n";
  for (const std::string& warning : result.warnings) html += "<li>" + escaped(warning) + "</li>\n";
  return html + "</ul></div>\n";
}

}  // namespace moat::html
