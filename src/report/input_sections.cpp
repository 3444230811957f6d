#include "report/sections.hpp"

#include <algorithm>

#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"
#include "report/html.hpp"

namespace moat::html {
namespace {

// Rows of a table that the report shows; summary.json has all of them.
constexpr std::size_t most_rows = 100;
// A table with more rows is closed until the reader opens it.
constexpr std::size_t rows_at_a_glance = 20;

std::string row_if_known(std::string_view name, const std::string& text) {
  return text.empty() ? "" : text_row(name, text);
}

template <class Facts, class Row>
std::string list_of(const std::vector<Facts>& all, const std::string& what, const std::string& head, const Row& row) {
  std::string html = "<details" + std::string{all.size() <= rows_at_a_glance ? " open" : ""} + "><summary>" +
                     std::to_string(all.size()) + " " + what + "</summary>\n<table>\n" + head;
  for (std::size_t i = 0; i < std::min(all.size(), most_rows); ++i) html += row(all[i]);
  html += "</table>\n";
  if (all.size() > most_rows)
    html += "<p>... and " + std::to_string(all.size() - most_rows) + " more in summary.json.</p>\n";
  return html + "</details>\n";
}

std::string number_cell(double value) { return "<td class=\"number\">" + to_significant(value, 6) + "</td>"; }

// A number without dimension has the unit 1.
std::string value_with_unit(double value, std::string_view unit) {
  return to_significant(value, 6) + (unit == "1" ? "" : " " + with_raised_digits(unit));
}

std::string text_of(const std::vector<ParameterFacts>& parameters) {
  std::string text;
  for (const ParameterFacts& each : parameters)
    text += (text.empty() ? "" : ", ") + in_words(each.name) + " " + value_with_unit(each.value, each.unit);
  return text;
}

// On one line.
std::string text_of(PlanVector at) { return "(" + to_significant(at.x, 6) + ",\u00a0" + to_significant(at.y, 6) + ")"; }

// Where a spring in plan is attached, and its direction.
std::string place_of(const ElementFacts& element) {
  if (!element.plan_places) return "";
  const auto& [first, second, direction] = *element.plan_places;
  const std::string places =
      first.x == second.x && first.y == second.y ? text_of(first) : text_of(first) + " to " + text_of(second);
  return dot(direction, direction) > 0.0 ? places + " along " + text_of(direction) : places;
}

// Returns the text of an end at a node, or between two.
std::string end_text(const std::string& node, const std::string& other, double share) {
  if (other.empty()) return node;
  return to_significant(share, 6) + " of the way from " + node + " to " + other;
}

}  // namespace

std::string provenance_section(const Provenance& provenance) {
  std::string version = provenance.moat_version;
  if (!provenance.git_commit.empty()) version += ", commit " + provenance.git_commit;
  std::string html = "<h2>Origin</h2>\n<table>\n";
  html += row_if_known("Command line", provenance.command_line);
  html += row_if_known("Script", provenance.script);
  html += row_if_known("SHA-256 of the script", provenance.script_sha256);
  for (const auto& [name, value] : provenance.options) html += text_row("--" + name, value);
  html += row_if_known("Version of moat", version);
  html += row_if_known("Date", provenance.date);
  return html + "</table>\n";
}

std::string analysis_section(const AnalysisFacts& analysis) {
  std::string html = "<h2>Options of the analysis</h2>\n<table>\n";
  html += row_if_known("integrator", analysis.integrator);
  html += row_if_known("events", analysis.events);
  html += row_if_known("error bars", analysis.error_bars);
  html += row_if_known("sensitivity to contacts", analysis.contact_sensitivity);
  for (const Parameter& option : analysis.options)
    html += number_row(std::string{option.name}, value_with_unit(option.value, option.unit));
  return html + "</table>\n";
}

std::string motion_section(const MotionFacts& motion) {
  std::string html = "<h2>Ground motion</h2>\n<table>\n";
  html += number_row("Name", motion.name);
  html += number_row("Peak acceleration", number_with_unit(motion.peak_acceleration, "m/s^2"));
  html += number_row("Peak velocity", number_with_unit(motion.peak_velocity, "m/s"));
  html += number_row("Time step", number_with_unit(motion.time_step, "s"));
  html += number_row("Duration", number_with_unit(motion.duration, "s"));
  const bool several = motion.components.size() > 1;
  for (const MotionComponent& component : motion.components)
    html += number_row("Scale factor" + (several ? " of " + component.name : ""),
                       to_significant(component.scale_factor, 6));
  html += "</table>\n";
  for (const MotionComponent& component : motion.components)
    if (!component.file.path.empty())
      html += "<table>\n" + text_row("File", component.file.path) + text_row("SHA-256", component.file.sha256) +
              "</table>\n";
  if (motion.notes.empty()) return html;
  html += "<ul>\n";
  for (const std::string& note : motion.notes) html += "<li>" + escaped(note) + "</li>\n";
  return html + "</ul>\n";
}

std::string model_section(const ModelFacts& model) {
  if (model.nodes.empty()) return "";
  const bool at_rest = std::ranges::all_of(model.nodes, [](const NodeFacts& node) {
    return node.initial_displacement == 0.0 && node.initial_velocity == 0.0;
  });
  std::string html = "<h2>Model</h2>\n";
  html += list_of(model.nodes, "nodes",
                  std::string{"<tr><th>Node</th><th class=\"number\">Mass [kg]</th><th class=\"number\">x [m]</th>"
                              "<th class=\"number\">Height [m]</th>"} +
                      (at_rest ? ""
                               : "<th class=\"number\">Initial displacement [m]</th>"
                                 "<th class=\"number\">Initial velocity [m/s]</th>") +
                      "</tr>\n",
                  [at_rest](const NodeFacts& node) {
                    const std::string initial =
                        at_rest ? "" : number_cell(node.initial_displacement) + number_cell(node.initial_velocity);
                    return "<tr>" + cell(node.name) + number_cell(node.mass) + number_cell(node.x) +
                           number_cell(node.height) + initial + "</tr>\n";
                  });
  const bool in_plan = !model.diaphragms.empty();
  html += list_of(model.elements, "elements",
                  std::string{"<tr><th>Element</th><th>Law</th><th>From</th><th>To</th>"} +
                      (in_plan ? "<th>At [m]</th>" : "") + "<th>Parameters</th></tr>\n",
                  [in_plan](const ElementFacts& element) {
                    return "<tr>" + cell(element.name) + cell(element.law) +
                           cell(end_text(element.first, element.first_other, element.first_share)) +
                           cell(end_text(element.second, element.second_other, element.second_share)) +
                           (in_plan ? cell(place_of(element)) : "") + cell(text_of(element.parameters)) + "</tr>\n";
                  });
  if (!in_plan) return html;
  html += list_of(model.diaphragms, "diaphragms",
                  "<tr><th>Diaphragm</th><th class=\"number\">Radius of gyration [m]</th><th>Centre of mass [m]</th>"
                  "<th>Outline [m]</th></tr>\n",
                  [](const DiaphragmFacts& each) {
                    std::string outline;
                    for (const PlanVector corner : each.outline)
                      outline += (outline.empty() ? "" : " ") + text_of(corner);
                    return "<tr>" + cell(each.name) + number_cell(each.gyration) + cell(text_of(each.centre_of_mass)) +
                           cell(outline) + "</tr>\n";
                  });
  if (model.corners.empty()) return html;
  html += list_of(model.corners, "corners and edges",
                  "<tr><th>Corner</th><th>At [m]</th><th>Edge</th><th>From [m]</th><th>To [m]</th>"
                  "<th class=\"number\">Clearance [m]</th></tr>\n",
                  [](const CornerFacts& each) {
                    return "<tr>" + cell(each.corner) + cell(text_of(each.position)) + cell(each.edge) +
                           cell(text_of(each.edge_begin)) + cell(text_of(each.edge_end)) + number_cell(each.clearance) +
                           "</tr>\n";
                  });
  return html;
}

}  // namespace moat::html
