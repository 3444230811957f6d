// The script of the page, run without a browser: texts that the chart library reads as HTML.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "in_folder.hpp"
#include "report/report.hpp"
#include "report_testing.hpp"

namespace moat {
namespace {

// Enough of a browser for the histories; prints the options that the chart library gets.
constexpr std::string_view harness = R"js(
const html = require("fs").readFileSync(process.argv[2], "utf8");
const data = /<script type="application\/json" id="run-data">([^]*?)<\/script>/.exec(html)[1];
const page = html.slice(html.lastIndexOf("<script>") + 8, html.lastIndexOf("</script>"));
class Element {
  constructor() { this.dataset = {}; }
  setAttribute() {}
  append() {}
  replaceWith() {}
  addEventListener() {}
}
globalThis.window = globalThis;
globalThis.getComputedStyle = () => ({ getPropertyValue: () => "#123456" });
globalThis.document = {
  documentElement: new Element(),
  getElementById: (id) => id === "run-data" ? { textContent: data } : null,
  querySelector: () => null,
  querySelectorAll: (selector) => selector !== "figure[data-history]" ? [] : JSON.parse(data).charts.map((_, i) => {
    const figure = new Element();
    figure.dataset.history = i;
    return figure;
  }),
  createElement: () => new Element(),
};
const options = [];
globalThis.Dygraph = class { constructor(plot, rows, given) { options.push(given); } };
new Function(page)();
console.log(JSON.stringify(options));
)js";

bool has_node() { return std::system("command -v node >/dev/null 2>&1") == 0; }  // NOLINT(concurrency-mt-unsafe)

std::string without_entities(std::string text) {
  for (std::smatch found; std::regex_search(text, found, std::regex{"&#([0-9]+);"});)
    text.replace(static_cast<std::size_t>(found.position()), static_cast<std::size_t>(found.length()), 1,
                 static_cast<char>(std::stoi(found[1])));
  return text;
}

using PageScript = testing::InFolder;

TEST_F(PageScript, GivesTitlesOfAxesAsText) {
  if (!has_node()) GTEST_SKIP() << "the program node is not installed (package nodejs)";
  const std::string quantity = "<img src=x onerror='alert(1)'>", unit = "<b onmouseover=\"alert(2)\">N</b> & &lt;";
  CaseResult result = testing_report::result_with(
      {{"time", "", "s", {0.0, 1.0, 2.0}}, {quantity, "<i>tower</i>", unit, {0.0, 1.0, 0.5}}});
  result.offered = {{quantity, "<i>tower</i>", unit}};
  write_report_html(result, result_charts(result), folder);
  std::ofstream{folder / "harness.js"} << harness;
  const std::string command = "cd '" + folder.string() + "' && node harness.js report.html >options.json";
  ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT(concurrency-mt-unsafe)
  const nlohmann::json options = nlohmann::json::parse(testing::read_file(folder / "options.json"));
  ASSERT_EQ(options.size(), 1u);
  for (const char* title : {"ylabel", "xlabel", "title", "y2label"}) {
    const std::string html = options[0].value(title, "");
    EXPECT_EQ(html.find_first_of("<>\"'"), std::string::npos) << html;
    EXPECT_FALSE(std::regex_search(html, std::regex{"&(?!#[0-9]+;)"})) << html;
  }
  const std::string label = without_entities(options[0].at("ylabel"));
  EXPECT_NE(label.find(quantity), std::string::npos) << label;
  EXPECT_NE(label.find(unit), std::string::npos) << label;
}

}  // namespace
}  // namespace moat
