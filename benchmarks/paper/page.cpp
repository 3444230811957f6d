#include "paper/exhibit.hpp"

#include "output/files/file_io.hpp"

namespace moat::paper {
namespace {

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
ShownTable findings_of(const std::vector<Exhibit>& exhibits) {
  ShownTable table{"", {"where", "claim", "criterion", "found", "verdict"}, {}};
  for (const Exhibit& exhibit : exhibits)
    for (const Finding& each : exhibit.findings)
      table.rows.push_back({each.source, each.claim, each.criterion, each.found, name_of(each.verdict)});
  return table;
}

ShownTable short_findings_of(const std::vector<Exhibit>& exhibits) {
  ShownTable table{"", {"where", "claim", "found", "verdict"}, {}};
  for (const Exhibit& exhibit : exhibits)
    for (const Finding& each : exhibit.findings)
      table.rows.push_back(
          {each.source, each.claim, each.in_short.empty() ? each.found : each.in_short, name_of(each.verdict)});
  return table;
}

constexpr const char* about_findings =
    "In the plain reading of the paper's numbers. The criteria are ours: the paper gives none.";

}  // namespace

std::string Totals::in_words() const {
  return std::to_string(asserted) + " asserted, " + std::to_string(held) + " held, " + std::to_string(reported) +
         " reported";
}

Totals totals_of(const std::vector<Exhibit>& exhibits) {
  Totals totals;
  for (const Exhibit& exhibit : exhibits) {
    totals.asserted += exhibit.assertions.size();
    totals.held += exhibit.held();
    totals.reported += exhibit.reported;
    totals.skipped += exhibit.skipped.empty() ? 0 : 1;
  }
  return totals;
}

void write_page(const std::filesystem::path& folder, const std::vector<Exhibit>& exhibits) {
  std::string page = page_start;
  page +=
      "<h1>Modified Hertz-damp model for base-isolated structural pounding</h1>\n"
      "<p>The tables and figures of Zhao, Liu &amp; Li, Journal of Vibroengineering (2017), "
      "doi:10.21595/jve.2017.17293, computed by moat.</p>\n<p><b>" +
      totals_of(exhibits).in_words() +
      ".</b> Asserted numbers have a bound; reported ones stand beside the paper's number without a bound.</p>\n<nav>";
  for (const Exhibit& exhibit : exhibits) page += "<a href=\"#" + exhibit.id + "\">" + exhibit.id + "</a>";
  page += "<a href=\"#findings\">findings</a></nav>\n";
  for (const Exhibit& exhibit : exhibits) page += exhibit.html();
  if (const ShownTable findings = findings_of(exhibits); !findings.rows.empty()) {
    page += std::string{"<h2 id=\"findings\">Claims of the paper, and findings of moat</h2>\n<p>"} + about_findings +
            "</p>\n" + html_table(findings);
  }
  write_file(folder / "index.html", page + "</body></html>\n");
}

std::string documentation(const std::vector<Exhibit>& exhibits) {
  std::string text =
      "**" + totals_of(exhibits).in_words() +
      ".** Asserted are Table 1 against the laws its columns were computed with, the\n"
      "paper's building against peaks of an independent program, and the displacements and the number of impacts of\n"
      "Table 2. All other numbers and all figures are on the page that the command makes.\n\n";
  for (const Exhibit& exhibit : exhibits) text += exhibit.markdown();
  text += std::string{"### Claims of the paper, and findings of moat\n\n"} + about_findings + "\n\n" +
          markdown_table(short_findings_of(exhibits));
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

}  // namespace moat::paper
