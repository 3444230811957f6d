#include "output/report_page.hpp"

#include "output/chart_style.hpp"
#include "output/report_html.hpp"

namespace moat::html {
namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; }
body { font: 15px/1.5 Arial, Helvetica, "Liberation Sans", sans-serif; color: #222; max-width: 1040px;
       margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.6em; margin-bottom: .2em; }
h2 { font-size: 1.2em; margin-top: 2em; border-bottom: 1px solid #ccc; padding-bottom: .2em; }
table { border-collapse: collapse; margin: .8em 0; }
th, td { padding: .2em .9em; text-align: left; border-bottom: 1px solid #e4e4e4; }
th { background: #f3f5f7; }
tr.group th { background: none; padding-top: .9em; border-bottom: 1px solid #888; }
td:first-child { white-space: nowrap; }
td.text { overflow-wrap: anywhere; }
summary { cursor: pointer; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
td.error { padding-left: 0; white-space: nowrap; font-variant-numeric: tabular-nums; }
tr.group th:nth-child(3):empty { padding: 0; }
tr.unsettled td { background: #fdf0e0; }
.missing { visibility: hidden; }
.sensitive { background: #fdf0e0; border-left: 4px solid #c55a11; padding: .5em .9em; }
svg { max-width: 100%; height: auto; display: block; }
)";

constexpr std::string_view dark_style = R"(
body { background: #16181b; color: #ddd; }
h2 { border-color: #555; }
th, td { border-color: #3a3d42; }
th { background: #25282d; }
tr.group th { border-color: #888; }
tr.unsettled td, .sensitive { background: #45341f; }
)";

/// Dark where the reader's system is, and light on paper.
std::string whole_style() {
  return std::string{style} + "@media screen and (prefers-color-scheme: dark) {" + std::string{dark_style} +
         std::string{chart_style::dark_rules} + "}\n";
}

}  // namespace

std::string page(std::string_view title, std::string_view body) {
  const std::string heading = escaped(title);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + heading +
         "</title>\n<style>" + whole_style() + "</style>\n</head>\n<body>\n<h1>" + heading + "</h1>\n" +
         std::string{body} + "</body>\n</html>\n";
}

}  // namespace moat::html
