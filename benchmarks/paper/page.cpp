#include "paper/page.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.hpp"
#include "output/files/file_io.hpp"

namespace moat::paper {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream{path, std::ios::binary};
  if (!stream) throw FileError{path.string() + ": cannot be read."};
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

Json results_of(const std::filesystem::path& folder, const ScriptRun& run) {
  return Json::parse(text_of(folder / (run.id + ".json")));
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else
      result += c;
  }
  return result;
}

std::string string_of(const Json& json, const char* key) { return json.at(key).get<std::string>(); }

std::size_t held_in(const Json& checks) {
  std::size_t held = 0;
  for (const Json& check : checks) held += check.at("held").get<bool>() ? 1 : 0;
  return held;
}

std::string checks_in_words(const Json& checks) {
  return std::to_string(checks.size()) + " asserted, " + std::to_string(held_in(checks)) + " held.";
}

// --------------------------------------------------------------------------------------------- a page

constexpr const char* page_start = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>moat: Zhao, Liu &amp; Li (2017)</title>
<style>
body { font: 16px/1.5 Arial, Helvetica, "Liberation Sans", "DejaVu Sans", sans-serif; color: #222; background: #fff;
       max-width: 1020px; margin: 0 auto; padding: 16px; }
h1 { font-size: 26px; } h2 { font-size: 20px; margin-top: 44px; border-top: 1px solid #ccc; padding-top: 12px; }
table { border-collapse: collapse; font-size: 13px; margin: 12px 0 24px; }
caption { text-align: left; font-weight: bold; padding: 6px 0; font-size: 14px; }
th, td { border: 1px solid #ccc; padding: 4px 8px; vertical-align: top; text-align: left; }
th { background: #f1f3f5; } td { font-variant-numeric: tabular-nums; }
figure { margin: 16px 0; } figure svg { display: block; max-width: 100%; height: auto; }
figcaption, .note { font-size: 14px; color: #444; }
.holds { color: #00704f; font-weight: bold; } .fails { color: #b02a00; font-weight: bold; }
.partly { color: #8a5a00; font-weight: bold; }
.scroll { overflow-x: auto; } nav a { margin-right: 14px; }
</style></head><body>
)";

void add_table(std::string& page, const Json& block) {
  page += "<div class=\"scroll\"><table><caption>" + escaped(string_of(block, "caption")) + "</caption>\n<tr>";
  for (const Json& cell : block.at("header")) page += "<th>" + escaped(cell.get<std::string>()) + "</th>";
  page += "</tr>\n";
  for (const Json& row : block.at("rows")) {
    page += "<tr>";
    for (const Json& cell : row) page += "<td>" + escaped(cell.get<std::string>()) + "</td>";
    page += "</tr>\n";
  }
  page += "</table></div>\n";
}

void add_block(std::string& page, const std::filesystem::path& folder, const Json& block) {
  const std::string type = string_of(block, "type");
  if (type == "text") page += "<p>" + escaped(string_of(block, "text")) + "</p>\n";
  if (type == "table") add_table(page, block);
  if (type == "numbers")
    page += "<p class=\"note\">All numbers: <a href=\"" + string_of(block, "file") + "\">" + string_of(block, "file") +
            "</a></p>\n";
  if (type == "figure") {
    const std::string svg = text_of(folder / string_of(block, "file"));
    page += "<figure id=\"" + string_of(block, "name") + "\">\n" + svg.substr(svg.find("<svg")) + "<figcaption>" +
            escaped(string_of(block, "caption")) + "</figcaption></figure>\n";
  }
}

void add_checks(std::string& page, const Json& checks) {
  if (checks.empty()) return;
  page += "<details><summary>" + checks_in_words(checks) + "</summary><ul class=\"note\">\n";
  for (const Json& check : checks) {
    const bool held = check.at("held").get<bool>();
    page += std::string{"<li><span class=\""} + (held ? "holds\">held" : "fails\">did not hold") + "</span> " +
            escaped(string_of(check, "what")) + "</li>\n";
  }
  page += "</ul></details>\n";
}

void add_findings(std::string& page, const std::filesystem::path& folder, const std::vector<ScriptRun>& runs) {
  std::string rows;
  for (const ScriptRun& run : runs) {
    if (!run.failure.empty()) continue;
    const Json results = results_of(folder, run);
    for (const Json& finding : results.at("findings")) {
      const std::string verdict = string_of(finding, "verdict");
      rows += "<tr><td>" + escaped(string_of(finding, "source")) + "</td><td>" + escaped(string_of(finding, "claim")) +
              "</td><td>" + escaped(string_of(finding, "criterion")) + "</td><td>" +
              escaped(string_of(finding, "found")) + "</td><td class=\"" +
              (verdict == "does not hold" ? "fails" : verdict) + "\">" + verdict + "</td></tr>\n";
    }
  }
  if (rows.empty()) return;
  page +=
      "<h2 id=\"findings\">Claims of the paper, and findings of moat</h2>\n"
      "<p>In the plain reading of the paper's numbers. The criteria are ours: the paper gives none.</p>\n"
      "<div "
      "class=\"scroll\"><table><tr><th>where</th><th>claim</th><th>criterion</th><th>found</th><th>verdict</th></"
      "tr>\n" +
      rows + "</table></div>\n";
}

std::string totals_in_words(const Totals& totals) {
  return std::to_string(totals.asserted) + " asserted, " + std::to_string(totals.held) + " held, " +
         std::to_string(totals.reported) + " reported";
}

}  // namespace

Totals totals_of(const std::filesystem::path& folder, const std::vector<ScriptRun>& runs) {
  Totals totals;
  for (const ScriptRun& run : runs) {
    if (!run.failure.empty()) continue;
    const Json results = results_of(folder, run);
    totals.asserted += results.at("checks").size();
    totals.held += held_in(results.at("checks"));
    totals.reported += results.at("reported").get<std::size_t>();
    totals.skipped += string_of(results, "skipped").empty() ? 0 : 1;
  }
  return totals;
}

void write_page(const std::filesystem::path& folder, const std::vector<ScriptRun>& runs) {
  std::string page = page_start;
  page +=
      "<h1>Modified Hertz-damp model for base-isolated structural pounding</h1>\n"
      "<p>The tables and figures of Zhao, Liu &amp; Li, Journal of Vibroengineering (2017), "
      "doi:10.21595/jve.2017.17293, computed by moat.</p>\n";
  page +=
      "<p><b>" + totals_in_words(totals_of(folder, runs)) +
      ".</b> Asserted numbers have a bound; reported ones stand beside the paper's number without a bound.</p>\n<nav>";
  for (const ScriptRun& run : runs) page += "<a href=\"#" + run.id + "\">" + run.id + "</a>";
  page += "<a href=\"#findings\">findings</a></nav>\n";
  for (const ScriptRun& run : runs) {
    if (!run.failure.empty()) {
      page += "<h2 id=\"" + run.id + "\">" + run.id + "</h2><p class=\"fails\">" + escaped(run.failure) + "</p>\n";
      continue;
    }
    const Json results = results_of(folder, run);
    page += "<section id=\"" + run.id + "\"><h2>" + escaped(string_of(results, "title")) + "</h2>\n";
    if (const std::string reason = string_of(results, "skipped"); !reason.empty())
      page += "<p>Skipped: " + escaped(reason) + "</p>\n";
    for (const Json& block : results.at("blocks")) add_block(page, folder, block);
    add_checks(page, results.at("checks"));
    page += "<p class=\"note\">Computed by benchmarks/paper/" + run.program + ".cpp</p></section>\n";
  }
  add_findings(page, folder, runs);
  write_file(folder / "index.html", page + "</body></html>\n");
}

namespace {

std::string in_cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.replace(at, 1, "\\|");
  return text;
}

std::string row_of(const Json& cells) {
  std::string row = "|";
  for (const Json& cell : cells) row += " " + in_cell(cell.get<std::string>()) + " |";
  return row + "\n";
}

std::string markdown_table(const Json& header, const Json& rows) {
  std::string text = row_of(header) + "|";
  for (std::size_t i = 0; i < header.size(); ++i) text += " --- |";
  text += "\n";
  for (const Json& row : rows) text += row_of(row);
  return text + "\n";
}

}  // namespace

std::string documentation(const std::filesystem::path& folder, const std::vector<ScriptRun>& runs) {
  std::string text =
      "**" + totals_in_words(totals_of(folder, runs)) +
      ".** Asserted are Table 1 against the laws its columns were computed with, the\n"
      "paper's building against peaks of an independent program, and the displacements and the number of impacts of\n"
      "Table 2. Everything else stands beside the paper's number with its ratio.\n\n";
  Json findings = Json::array();
  for (const ScriptRun& run : runs) {
    const Json results = results_of(folder, run);
    text += "### " + string_of(results, "title") + "\n\nComputed by `benchmarks/paper/" + run.program + ".cpp`.";
    if (!results.at("checks").empty()) text += " " + checks_in_words(results.at("checks"));
    text += "\n\n";
    for (const Json& check : results.at("checks"))
      if (!check.at("held").get<bool>()) text += "- Did not hold: " + string_of(check, "what") + "\n\n";
    for (const Json& block : results.at("blocks")) {
      const std::string type = string_of(block, "type");
      if (type == "text") text += string_of(block, "text") + "\n\n";
      if (type == "figure")
        text += "Figure `" + string_of(block, "file") + "`: " + string_of(block, "caption") + "\n\n";
      if (type == "table")
        text += "**" + string_of(block, "caption") + "**\n\n" + markdown_table(block.at("header"), block.at("rows"));
    }
    for (const Json& finding : results.at("findings"))
      findings.push_back({finding.at("source"), finding.at("claim"), finding.at("criterion"), finding.at("found"),
                          finding.at("verdict")});
  }
  text +=
      "### Claims of the paper, and findings of moat\n\nIn the plain reading of the paper's numbers. The criteria are "
      "ours: the paper gives none.\n\n" +
      markdown_table({"where", "claim", "criterion", "found", "verdict"}, findings);
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

}  // namespace moat::paper
