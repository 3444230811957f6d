#include "report/sections.hpp"

#include <algorithm>
#include <cmath>

#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"
#include "output/recorders/impact_columns.hpp"
#include "report/charts/result_charts.hpp"
#include "report/html.hpp"

namespace moat::html {
namespace {

std::string heading(const char* name, const char* unit, const char* meaning) {
  const EngineeringUnit shown = engineering_unit(unit);
  return "<th class=\"number\" scope=\"col\" title=\"" + escaped(meaning) + "\">" +
         escaped(capitalised(in_words(name))) +
         (shown.symbol == "1" ? "" : " [" + escaped(with_raised_digits(shown.symbol)) + "]") + "</th>";
}

std::string table_of(const std::vector<Impact>& impacts, std::size_t rows) {
  std::string html =
      "<div class=\"wide\"><table class=\"dense\">\n<tr><th scope=\"col\">Where</th><th class=\"number\" "
      "scope=\"col\"></th>";
  const std::vector<ImpactColumn> columns = columns_of(impacts);
  std::vector<int> decimals;
  for (const ImpactColumn& column : columns) {
    html += heading(column.name, column.unit, column.meaning);
    double largest = 0.0;
    for (const Impact& impact : impacts)
      largest = std::max(largest, std::abs(engineering_unit(column.unit).per_si * (impact.*column.value)));
    decimals.push_back(std::max(decimals_for(largest), column.least_decimals));
  }
  html += "</tr>\n";
  for (std::size_t row = 0; row < rows; ++row) {
    const Impact& impact = impacts[row];
    html += "<tr><td>" + escaped(impact.where) + "</td><td><button class=\"jump\" type=\"button\" hidden data-time=\"" +
            to_significant(impact.start, 9) + "\" aria-label=\"Show impact " + std::to_string(row + 1) +
            " in the drawing\">Show</button></td>";
    for (std::size_t i = 0; i < columns.size(); ++i)
      html += "<td class=\"number\">" +
              with_decimals(engineering_unit(columns[i].unit).per_si * (impact.*columns[i].value), decimals[i]) +
              "</td>";
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string meanings(const std::vector<Impact>& impacts) {
  std::string html = "<details><summary>The columns</summary>\n<ul>\n";
  for (const ImpactColumn& column : columns_of(impacts))
    html += "<li>" + escaped(capitalised(in_words(column.name))) + ": " + escaped(column.meaning) + "</li>\n";
  return html + "</ul></details>\n";
}

// The restitution that the law of a gap was given; empty for a law without one.
std::string requested_restitution(const ModelFacts& model, const std::string& gap) {
  const auto element = std::ranges::find(model.elements, gap, &ElementFacts::name);
  if (element == model.elements.end()) return "";
  const auto given = std::ranges::find(element->parameters, "restitution", &ParameterFacts::name);
  return given == element->parameters.end() ? "" : to_significant(given->value, 4);
}

std::string ratio(double value) { return std::isfinite(value) ? to_significant(value, 4) : "none"; }

std::string loop_section(const CaseResult& result, const std::vector<Chart>& loops) {
  if (loops.empty()) return "";
  std::string html = "<h3>Force over indentation</h3>\n";
  if (loops.size() < result.impacts.size())
    html += "<p>The " + std::to_string(loops.size()) + " impacts with the largest forces.</p>\n";
  html += chart_grid(loops, 500, 260) +
          "<div class=\"wide\"><table>\n<tr><th scope=\"col\">Impact</th>"
          "<th class=\"number\" scope=\"col\">Restitution asked of the law</th>"
          "<th class=\"number\" scope=\"col\">delivered by it</th>"
          "<th class=\"number\" scope=\"col\">rebound ratio in this run</th></tr>\n";
  for (const Impact& impact : result.impacts) {
    const std::string title = title_of(impact);
    if (std::ranges::find(loops, title, &Chart::title) == loops.end()) continue;
    const std::string requested = requested_restitution(result.model, impact.where);
    html += "<tr><td>" + escaped(title) + "</td><td class=\"number\">" + (requested.empty() ? "-" : requested) +
            "</td><td class=\"number\">" + ratio(impact.restitution) + "</td><td class=\"number\">" +
            ratio(impact.rebound_ratio) + "</td></tr>\n";
  }
  return html + "</table></div>\n";
}

}  // namespace

std::string impact_section(const CaseResult& result, const std::vector<Chart>& loops) {
  if (result.impacts.empty()) return "<h2>Impacts</h2>\n<p>No contact.</p>\n";
  const std::size_t rows = std::min(result.impacts.size(), most_impacts);
  std::string html = "<h2>Impacts</h2>\n" + table_of(result.impacts, rows);
  if (rows < result.impacts.size())
    html += "<p>... and " + std::to_string(result.impacts.size() - rows) + " more in impacts.csv.</p>\n";
  return html + meanings(result.impacts) + loop_section(result, loops);
}

}  // namespace moat::html
