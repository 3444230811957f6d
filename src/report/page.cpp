#include "report/page.hpp"

#include <embedded/page_css.hpp>
#include <embedded/page_js.hpp>
#include <fstream>
#include <iterator>

#include "output/charts/chart_style.hpp"
#include "report/html.hpp"

namespace moat::html {
namespace {

/// JSON inside a script element, which a "<" of a name could end.
std::string inside_script(std::string_view json) {
  std::string safe;
  for (const char c : json) {
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

std::string framed(std::string_view title, std::string_view body, const std::string& scripts) {
  const std::string heading = escaped(title);
  // Dark where the reader's system is, and light on paper.
  const std::string dark_charts =
      "@media screen and (prefers-color-scheme: dark) {\n" + std::string{chart_style::dark_rules} + "}\n";
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         heading + "</title>\n<style>\n" + std::string{embedded::page_css} + dark_charts +
         "</style>\n</head>\n<body>\n<h1>" + heading + "</h1>\n" + std::string{body} + scripts + "</body>\n</html>\n";
}

}  // namespace

std::string page(std::string_view title, std::string_view body) { return framed(title, body, ""); }

std::string page_with_script(std::string_view title, std::string_view body, std::string_view data) {
  return framed(title, body,
                chart_library() + "<script type=\"application/json\" id=\"run-data\">" + inside_script(data) +
                    "</script>\n<script>\n" + std::string{embedded::page_js} + "</script>\n");
}

}  // namespace moat::html
