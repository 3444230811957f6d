#include "paper/exhibit.hpp"

#include <algorithm>
#include <cstdio>

#include "output/files/csv_writer.hpp"
#include "output/files/file_io.hpp"
#include "report/html.hpp"

namespace moat::paper {
namespace {

using html::escaped;

constexpr int figure_width = 1000;

// Verdicts are coloured.
std::string html_row(const Cells& cells, const std::string& tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) {
    std::string style;
    for (const auto& [verdict, name] :
         {std::pair{Verdict::holds, "holds"}, std::pair{Verdict::partly, "partly"}, std::pair{Verdict::fails, "fails"}})
      if (cell == name_of(verdict)) style = std::string{" class=\""} + name + "\"";
    row += "<" + tag + style + ">" + escaped(cell) + "</" + tag + ">";
  }
  return row + "</tr>\n";
}

std::string markdown_row(const Cells& cells) {
  std::string row = "|";
  for (std::string cell : cells) {
    for (std::size_t at = cell.find('|'); at != std::string::npos; at = cell.find('|', at + 2)) cell.insert(at, "\\");
    row += " " + cell + " |";
  }
  return row + "\n";
}

}  // namespace

std::string html_table(const ShownTable& table) {
  std::string html = "<div class=\"scroll\"><table>";
  if (!table.caption.empty()) html += "<caption>" + escaped(table.caption) + "</caption>\n";
  html += html_row(table.header, "th");
  for (const Cells& row : table.rows) html += html_row(row, "td");
  return html + "</table></div>\n";
}

std::string markdown_table(const ShownTable& table) {
  std::string text = markdown_row(table.header) + markdown_row(Cells(table.header.size(), "---"));
  for (const Cells& row : table.rows) text += markdown_row(row);
  return text + "\n";
}

std::string name_of(Verdict verdict) {
  return verdict == Verdict::holds ? "holds" : verdict == Verdict::partly ? "partly" : "does not hold";
}

void Exhibit::text(const std::string& paragraph) { as_html += "<p>" + escaped(paragraph) + "</p>\n"; }

void Exhibit::table(const ShownTable& table) { as_html += html_table(table); }

void Exhibit::documented_table(const ShownTable& shown) {
  table(shown);
  as_markdown += "**" + shown.caption + "**\n\n" + markdown_table(shown);
}

void Exhibit::figure(const ShownFigure& figure) {
  const std::string file = figure.name + ".svg";
  write_svg(figure.charts, folder / file, figure_width, figure.panel_height, figure.columns);
  as_html += "<figure id=\"" + figure.name + "\">\n" +
             svg_text(figure.charts, figure_width, figure.panel_height, figure.columns) + "<figcaption>" +
             escaped(figure.caption) + "</figcaption></figure>\n";
}

void Exhibit::numbers(const std::string& name, const Table& table) {
  const std::string file = name + ".csv";
  write_csv(table, folder / file);
  as_html += "<p class=\"note\">All numbers: <a href=\"" + file + "\">" + file + "</a></p>\n";
}

void Exhibit::assert_that(bool held, const std::string& what) {
  assertions.push_back({held, what});
  if (!held) std::fprintf(stderr, "moat: %s: did not hold: %s\n", id.c_str(), what.c_str());
}

std::size_t Exhibit::held() const {
  return static_cast<std::size_t>(std::ranges::count(assertions, true, &Assertion::held));
}

std::string Exhibit::counts() const {
  return std::to_string(assertions.size()) + " asserted, " + std::to_string(held()) + " held.";
}

std::string Exhibit::html() const {
  std::string page = "<section id=\"" + id + "\"><h2>" + escaped(title) + "</h2>\n";
  if (!failure.empty()) page += "<p class=\"fails\">" + escaped(failure) + "</p>\n";
  if (!skipped.empty()) page += "<p>Skipped: " + escaped(skipped) + "</p>\n";
  page += as_html;
  if (!assertions.empty()) page += "<details><summary>" + counts() + "</summary><ul class=\"note\">\n";
  for (const auto& [held, what] : assertions)
    page += std::string{"<li><span class=\""} + (held ? "holds\">held" : "fails\">did not hold") + "</span> " +
            escaped(what) + "</li>\n";
  if (!assertions.empty()) page += "</ul></details>\n";
  return page + "<p class=\"note\">Computed by benchmarks/paper/" + source + ".cpp</p></section>\n";
}

std::string Exhibit::markdown() const {
  if (as_markdown.empty() && held() == assertions.size()) return "";
  std::string text = "### " + title + "\n\nComputed by `benchmarks/paper/" + source + ".cpp`.";
  if (!assertions.empty()) text += " " + counts();
  text += "\n\n";
  for (const auto& [held, what] : assertions)
    if (!held) text += "- Did not hold: " + what + "\n\n";
  return text + as_markdown;
}

std::string ratio(double computed, double printed) { return to_fixed(computed / printed, 3); }

}  // namespace moat::paper
