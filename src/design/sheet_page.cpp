#include "design/sheet_page.hpp"

#include <array>
#include <embedded/sheet_css.hpp>
#include <regex>
#include <utility>

#include "output/files/file_io.hpp"
#include "report/html.hpp"

namespace moat {
namespace {

using html::escaped;

std::string verdict_box(const DesignSheet& sheet) {
  std::string first, broken;
  std::size_t kept = 0;
  bool is_broken = false;
  for (const SheetLine* rule : sheet.rules()) {
    const std::string text = formula_as_html(rule->verdict);
    is_broken = is_broken || rule->is_kept == false;
    if (rule->symbol == "gap")
      first = "<strong>" + text + "</strong>";
    else if (rule->is_kept != true)
      broken += "<br>" + text;
    else
      ++kept;
  }
  return "<div class=\"verdict" + std::string{is_broken ? " broken" : ""} + "\">" + first + broken + "<br>" +
         std::to_string(kept) + " other rules are kept.</div>\n";
}

std::string value_cell(const SheetLine& line, std::size_t bound) {
  const double value = line.values[bound];
  const std::string text = sheet_value(value, line.unit);
  const std::string number = value == 0.0 ? "-" : text.substr(0, text.find(' '));
  const bool is_bold = line.governs && static_cast<std::size_t>(line.of) == bound;
  return is_bold ? "<strong>" + number + "</strong>" : number;
}

std::string value_cells(const SheetLine& line) {
  if (line.values.empty()) return "<td></td><td></td><td></td>";
  if (line.values.size() == 1) return "<td class=\"all\" colspan=\"3\">" + value_cell(line, 0) + "</td>";
  std::string cells;
  for (std::size_t i = 0; i < line.values.size(); ++i) cells += "<td class=\"number\">" + value_cell(line, i) + "</td>";
  return cells;
}

std::string line_row(const SheetLine& line, bool repeats) {
  const std::string shown = line.values.empty() ? "" : sheet_value(1.0, line.unit);
  const std::string unit = shown.find(' ') == std::string::npos ? "" : shown.substr(shown.find(' ') + 1);
  const std::string mark =
      line.source == ClauseSource::recalled && !repeats ? " <span class=\"recalled\">recalled, not read</span>" : "";
  return "<tr><td>" + formula_as_html(line.symbol) + "</td><td>" + (repeats ? "" : formula_as_html(line.formula)) +
         "</td><td>" + formula_as_html(line.numbers) + "</td>" + value_cells(line) + "<td class=\"unit\">" +
         escaped(unit) + "</td><td>" +
         (!line.is_kept   ? (line.verdict.empty() ? "" : "not judged")
          : *line.is_kept ? "kept"
                          : "<span class=\"broken\">not kept</span>") +
         "</td><td>" + (repeats ? "" : escaped(line.clause)) + mark + "</td></tr>\n";
}

std::string section_of(const DesignSheet& sheet) {
  std::string body = "<section class=\"sheet\">\n<h2>" +
                     escaped((sheet.name.empty() ? "" : sheet.name + ": ") + sheet.code) + "</h2>\n" +
                     verdict_box(sheet) + "<div class=\"given\">";
  for (const GivenValue& each : sheet.given)
    body += "<span>" + formula_as_html(each.symbol) + " = " + escaped(sheet_value(each.value, each.unit)) + "</span>";
  body +=
      "</div>\n<table>\n<tr><th>Line</th><th>Formula</th><th>Numbers (kN, m, s)</th><th class=\"number\">Lower</th><th "
      "class=\"number\">Nominal</th><th class=\"number\">Upper</th><th>Unit</th><th>Rule</th><th>Clause</th></tr>\n";
  const SheetLine* before = nullptr;
  for (const SheetLine& line : sheet.lines) {
    body += line_row(line, before != nullptr && before->formula == line.formula && before->clause == line.clause);
    before = &line;
  }
  body += "</table>\n<div class=\"notes\">\n";
  for (const std::string& note : sheet.notes) body += "<p>" + formula_as_html(note) + "</p>\n";
  return body +
         "<p>Bold values govern; the numbers beside are those of their bound. <span class=\"recalled\">Recalled, not "
         "read</span>: formula and clause are from memory and must be compared with the code. Nobody of moat has read "
         "the code; formulas without this mark follow from statics or were read in published programs that follow "
         "it.</p>\n"
         "</div>\n<div class=\"signature\"><span>Designed, date</span> <span>Checked, date</span></div>\n</section>\n";
}

}  // namespace

std::string formula_as_html(const std::string& formula) {
  static const std::array<std::pair<std::regex, const char*>, 16> signs{{
      {std::regex{R"(_(\w+(,\w+)*))"}, "<sub>$1</sub>"},
      {std::regex{R"(\^\(([^()]*)\))"}, "<sup>$1</sup>"},
      {std::regex{R"(\^([\w.]+))"}, "<sup>$1</sup>"},
      {std::regex{"\\blambda\\b"}, "λ"},
      {std::regex{"\\bgamma\\b"}, "γ"},
      {std::regex{"\\bdelta\\b"}, "δ"},
      {std::regex{"\\bbeta\\b"}, "β"},
      {std::regex{"\\beta\\b"}, "η"},
      {std::regex{"\\bxi\\b"}, "ξ"},
      {std::regex{"\\bpi\\b"}, "π"},
      {std::regex{"\\bsqrt\\b"}, "√"},
      {std::regex{"\\bsum\\b"}, "Σ"},
      {std::regex{" x "}, " × "},
      {std::regex{"&gt;="}, "≥"},
      {std::regex{"&lt;="}, "≤"},
      {std::regex{" - "}, " − "},
  }};
  constexpr std::size_t longest = 2000;  // std::regex needs room on the stack for every character
  std::string html = escaped(formula);
  if (html.size() > longest) return html;
  for (const auto& [words, sign] : signs) html = std::regex_replace(html, words, sign);
  return html;
}

std::string sheet_page(const std::vector<DesignSheet>& sheets) {
  std::string body = "<style>\n" + std::string{embedded::sheet_css} + "</style>\n";
  for (const DesignSheet& sheet : sheets) body += section_of(sheet);
  return html::page("Design sheet", body);
}

void write_design_sheets(const std::vector<DesignSheet>& sheets, const std::filesystem::path& file) {
  write_file(file, sheet_page(sheets));
}

}  // namespace moat
