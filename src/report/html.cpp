#include "report/html.hpp"

#include <cmath>
#include <embedded/page_css.hpp>
#include <embedded/page_js.hpp>
#include <fstream>
#include <iterator>

#include "base/sha256.hpp"
#include "base/text/number_format.hpp"
#include "output/charts/chart_style.hpp"
#include "output/files/engineering_unit.hpp"

namespace moat::html {
namespace {

std::string row(std::string_view name, std::string_view value, std::string_view kind) {
  return "<tr><td>" + escaped(name) + "</td><td class=\"" + std::string{kind} + "\">" + escaped(value) + "</td></tr>\n";
}

/// JSON inside a script element, which a "<" of a name could end.
std::string inside_script(std::string_view json) {
  std::string safe;
  for (const char c : as_plain_text(json)) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

/// The library that zooms the histories, of the package libjs-dygraphs; empty where that is not installed: the page
/// then keeps its static charts.
std::string chart_library() {
  const std::string folder = "/usr/share/javascript/dygraphs/";
  std::string text;
  for (const char* name : {"dygraph.min.css", "dygraph.min.js"}) {
    std::ifstream file{folder + name, std::ios::binary};
    if (!file) return "";
    const std::string content{std::istreambuf_iterator<char>{file}, {}};
    const std::string element = std::string_view{name}.ends_with(".css") ? "style" : "script";
    text += "<" + element + ">" + content + "</" + element + ">\n";
  }
  return text;
}

// Lets the scripts of the page run, and no other: no script in a name, and no request to the network.
std::string policy_for(std::string_view scripts) {
  constexpr std::string_view begin = "<script>", end = "</script>";
  std::string hashes;
  for (std::size_t at = scripts.find(begin); at != std::string_view::npos; at = scripts.find(begin, at)) {
    at += begin.size();
    hashes += " 'sha256-" + sha256_in_base64(scripts.substr(at, scripts.find(end, at) - at)) + "'";
  }
  return "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
         "base-uri 'none'; form-action 'none'; script-src" +
         hashes + "\">\n";
}

std::string framed(std::string_view title, std::string_view body, const std::string& scripts) {
  const std::string heading = escaped(title);
  // Dark where the reader's system is, and light on paper.
  const std::string dark_charts =
      "@media screen and (prefers-color-scheme: dark) {\n" + std::string{chart_style::dark_rules} + "}\n";
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n" + policy_for(scripts) +
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" + heading +
         "</title>\n<style>\n" + std::string{embedded::page_css} + dark_charts + "</style>\n</head>\n<body>\n<h1>" +
         heading + "</h1>\n" + std::string{body} + scripts + "</body>\n</html>\n";
}

}  // namespace

std::string number_row(std::string_view name, std::string_view value) { return row(name, value, "number"); }

std::string text_row(std::string_view name, std::string_view value) { return row(name, value, "text"); }

std::string number_with_unit(double value_in_si, std::string_view si_symbol) {
  constexpr double very_small = 1e-3;
  const EngineeringUnit unit = engineering_unit(si_symbol);
  const double value = unit.per_si * value_in_si, magnitude = std::abs(value);
  const std::string number = magnitude > 0.0 && magnitude < very_small ? to_significant(value, 2)
                                                                       : with_decimals(value, decimals_for(magnitude));
  const EngineeringUnit second = second_unit(si_symbol);
  return number + " " + with_raised_digits(unit.symbol) +
         (second.symbol.empty() ? ""
                                : " (" + to_significant(second.per_si * value_in_si, 4) + " " + second.symbol + ")");
}

std::string chart_grid(const std::vector<Chart>& charts, int width, int height) {
  std::string html = "<div class=\"charts\" style=\"--width: " + std::to_string(width) + "px\">\n";
  for (const Chart& chart : charts) html += svg_text({chart}, width, height);
  return html + "</div>\n";
}

std::string wide_picture(const std::string& svg) { return "<div class=\"wide-picture\">\n" + svg + "</div>\n"; }

namespace {

std::string script() { return "<script>\n" + std::string{embedded::page_js} + "</script>\n"; }

}  // namespace

std::string page(std::string_view title, std::string_view body) { return framed(title, body, script()); }

std::string page_with_script(std::string_view title, std::string_view body, std::string_view data) {
  return framed(title, body,
                chart_library() + "<script type=\"application/json\" id=\"run-data\">" + inside_script(data) +
                    "</script>\n" + script());
}

}  // namespace moat::html
