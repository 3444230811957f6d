#include "output/files/sensitivity_table.hpp"
#include "report/html.hpp"
#include "report/sections.hpp"

namespace moat::html {

std::string sensitivity_section(const ContactSensitivity& sensitivity, const std::vector<Tornado>& charts) {
  if (!sensitivity.computed && sensitivity.runs_left_out == 0) return "";
  std::string html = "<h2>If contact differs</h2>\n";
  if (!charts.empty()) {
    constexpr int width = 500;
    html +=
        "<p>Peaks with other parameters of all contacts: filled where the parameter is larger, open where it is "
        "smaller; the small bar above the nominal value is its numerical error. One at a time; no probability; "
        "combinations may exceed it.</p>\n<div class=\"charts\" style=\"--width: " +
        std::to_string(width) + "px\">\n";
    for (const Tornado& chart : charts) html += svg_text(chart, width);
    html += "</div>\n<p>Impacts: " + std::to_string(sensitivity.impacts);
    for (const ContactVariation& change : sensitivity.changes)
      if (change.failure.empty()) html += "; " + escaped(label_of(change)) + " " + std::to_string(change.impacts);
    html += ".</p>\n";
  }
  const std::vector<std::string> notes = sensitivity_notes(sensitivity);
  if (notes.empty()) return html;
  html += "<ul>\n";
  for (const std::string& note : notes) html += "<li>" + escaped(note) + "</li>\n";
  return html + "</ul>\n";
}

}  // namespace moat::html
