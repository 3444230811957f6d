// Opens reports in a browser, as their readers do.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/sha256.hpp"
#include "design/sheet_page.hpp"
#include "hostile_strings.hpp"
#include "in_folder.hpp"
#include "report/html.hpp"
#include "report/report.hpp"
#include "report_testing.hpp"
#include "study/study_report.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

// Before the page: collects errors. Under virtual time the browser draws no frames, so frames come from a timer.
constexpr std::string_view before_page = R"js(<script>
window.problems = [];
window.addEventListener("error", (event) => window.problems.push(event.message));
for (const kind of ["error", "warn"]) console[kind] = (...text) => window.problems.push(text.join(" "));
document.addEventListener("securitypolicyviolation", (event) =>
  window.problems.push("refused: " + event.violatedDirective));
window.frames_drawn = 0;
window.requestAnimationFrame = (draw) => setTimeout(() => draw(16 * ++window.frames_drawn), 1);
</script>)js";

// Behind it: uses it, and writes a verdict.
constexpr std::string_view behind_page = R"js(<script>
(async () => {
  const wait = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));
  await wait(50);  // A refused script is an event of its own, behind this one.
  const verdict = { width: innerWidth, dark: matchMedia("(prefers-color-scheme: dark)").matches };
  verdict.clipped = document.documentElement.scrollWidth > innerWidth + 1;
  verdict.beyond_the_edge = [...document.body.querySelectorAll("*")].filter(
    (each) => verdict.clipped && !each.closest(".wide-picture, .wide") &&
      each.getBoundingClientRect().right > innerWidth + 1).slice(0, 9).map(
    (each) => each.tagName + "." + each.className + " " + (each.textContent || "").slice(0, 40));
  verdict.pictures = document.querySelectorAll("svg").length;
  verdict.without_marks = [...document.querySelectorAll("svg")].filter(
    (svg) => !svg.querySelector("polyline, polygon, path, circle, rect + rect")).length;
  const letters = [...document.querySelectorAll("svg text")].map((text) => {
    const svg = text.ownerSVGElement;
    return svg.getBoundingClientRect().width / svg.viewBox.baseVal.width * Number(text.getAttribute("font-size"));
  }).filter((size) => size > 0);
  verdict.smallest_letter = Math.min(100, ...letters);
  const controls = document.querySelector(".controls");
  if (controls) {
    const control = (name) => controls.querySelector("[name=" + name + "]");
    const floor = [...document.querySelectorAll(".drawing polygon[data-move]")].pop();
    const rest = floor.getAttribute("points");
    control("play").click();
    // A busy machine draws its first frame late.
    for (let i = 0; i < 3000 && moatReport.time() === 0; ++i) await wait(5);
    verdict.advanced = moatReport.time() > 0;
    for (let i = 0; i < 3000 && control("play").textContent === "Pause"; ++i) await wait(5);
    verdict.stopped_at = moatReport.time();
    verdict.moved = floor.getAttribute("points") !== rest;
    verdict.marked = document.querySelectorAll(".drawing .hit").length;
    verdict.dots = document.querySelectorAll(".drawing circle").length;
    const histories = moatReport.graphs;
    verdict.zooming_charts = histories.length;
    if (histories.length > 1) {
      const area = histories[0].getArea(), canvas = document.querySelector(".plot canvas:last-of-type");
      const box = canvas.getBoundingClientRect();
      const mouse = (kind, share) => canvas.dispatchEvent(new MouseEvent(kind, {
        bubbles: true, view: window, detail: 1, button: 0,
        clientX: box.left + area.x + share * area.w, clientY: box.top + area.y + 0.5 * area.h }));
      mouse("mousedown", 0.25);
      mouse("mousemove", 0.5);
      mouse("mouseup", 0.5);
      await wait(50);
      verdict.ranges = histories.map((graph) => graph.xAxisRange());
    }
    document.querySelector("button.jump").click();
    verdict.jumped_to = moatReport.time();
  }
  verdict.title = document.title;
  verdict.problems = window.problems;
  parent.postMessage(JSON.stringify(verdict), "*");
})();
</script>)js";

// Holds the page in a frame, which may be as narrow as a phone: a window of the browser is at least 500 pixels wide.
std::string page_around(const std::string& page, int width) {
  return "<!DOCTYPE html><body><script>addEventListener(\"message\", (event) => {"
         "const text = document.createElement(\"pre\"); text.id = \"verdict\"; text.textContent = event.data;"
         "document.body.append(text); });</script><iframe src=\"" +
         page + "\" width=\"" + std::to_string(width) + "\" height=\"900\"></iframe></body>\n";
}

bool has_browser() { return std::system("command -v chromium >/dev/null 2>&1") == 0; }  // NOLINT(concurrency-mt-unsafe)

class ReportInABrowser : public testing::InFolder {
 protected:
  void SetUp() override {
    if (!has_browser()) GTEST_SKIP() << "the browser chromium is not installed (package chromium)";
  }

  // Opens the report at a width, light or dark, and returns the verdict.
  [[nodiscard]] nlohmann::json open(int width, bool dark) const {
    std::string html = testing::read_file(folder / "report.html");
    html.insert(html.find("<head>") + 6, before_page);
    html.insert(html.rfind("</body>"), behind_page);
    // The policy of the page lets its own scripts run, and this one of the test.
    const std::string_view body = behind_page.substr(8, behind_page.size() - 17), scripts = "script-src";
    html.insert(html.find(scripts) + scripts.size(), " 'sha256-" + sha256_in_base64(body) + "'");
    const fs::path page = folder / "around.html", output = folder / "page_after";
    std::ofstream{folder / "tested.html"} << html;
    std::ofstream{page} << page_around("tested.html", width);
    const std::string command =
        "chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking "
        "--disable-component-update --disable-sync --hide-scrollbars --virtual-time-budget=60000 "
        "--blink-settings=preferredColorScheme=" +
        std::string{dark ? "0" : "1"} + " --user-data-dir='" + (folder / "browser").string() +
        "' --window-size=" + std::to_string(width + 100) + ",1000 --dump-dom 'file://" + page.string() + "' >'" +
        output.string() + "' 2>'" + (folder / "messages").string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;  // NOLINT(concurrency-mt-unsafe)
    const std::string after = testing::read_file(output), mark = "<pre id=\"verdict\">";
    const std::size_t begin = after.rfind(mark);
    if (begin == std::string::npos) {
      ADD_FAILURE() << "the page did not come to its end\n" << testing::read_file(folder / "messages");
      return {};
    }
    const std::size_t end = after.find("</pre>", begin);
    std::string text = after.substr(begin + mark.size(), end - begin - mark.size());
    for (const auto& [escaped, plain] :
         {std::pair<std::string, std::string>{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}})
      for (std::size_t at = text.find(escaped); at != std::string::npos; at = text.find(escaped, at + 1))
        text.replace(at, escaped.size(), plain);
    return nlohmann::json::parse(text);
  }

  // At a phone, a laptop and a large screen, light and dark.
  template <class Check>
  void open_everywhere(const Check& check) const {
    for (const int width : {360, 1280, 1920})
      for (const bool dark : {false, true}) {
        SCOPED_TRACE(std::to_string(width) + (dark ? " dark" : " light"));
        const nlohmann::json verdict = open(width, dark);
        if (verdict.is_null()) continue;
        EXPECT_EQ(verdict["problems"], nlohmann::json::array());
        EXPECT_EQ(verdict["dark"], dark);
        EXPECT_EQ(verdict["width"], width);
        EXPECT_EQ(verdict["clipped"], false) << verdict;
        EXPECT_EQ(verdict["without_marks"], 0);
        EXPECT_GE(verdict["smallest_letter"], 8.0) << "pixels; on a phone charts stand below each other, or scroll";
        EXPECT_GT(verdict["pictures"], 0);
        check(verdict);
      }
  }

  void expect_to_move(const CaseResult& result) const {
    ASSERT_FALSE(result.impacts.empty());
    const bool zooms = fs::exists("/usr/share/javascript/dygraphs/dygraph.min.js");
    open_everywhere([&](const nlohmann::json& verdict) {
      EXPECT_EQ(verdict["advanced"], true);
      EXPECT_EQ(verdict["moved"], true);
      EXPECT_NEAR(verdict["stopped_at"].get<double>(), result.impacts.front().start, 1e-6);
      EXPECT_EQ(verdict["marked"], 1) << "the gap that closed";
      EXPECT_EQ(verdict["dots"], result.model.diaphragms.empty() ? 0 : result.impacts.size()) << "on the orbits";
      EXPECT_NEAR(verdict["jumped_to"].get<double>(), result.impacts.front().start, 1e-6);
      if (!zooms) return;
      EXPECT_GE(verdict["zooming_charts"], 3);
      const double end = result.histories.values("time").back();
      for (const nlohmann::json& range : verdict["ranges"]) {
        EXPECT_NEAR(range[0].get<double>(), 0.25 * end, 0.02 * end) << verdict["ranges"];
        EXPECT_NEAR(range[1].get<double>(), 0.5 * end, 0.02 * end);
      }
    });
  }
};

TEST_F(ReportInABrowser, MovesAModelOnALine) {
  const CaseResult result = testing_report::line_result();
  write_report_html(result, result_charts(result), folder);
  expect_to_move(result);
}

TEST_F(ReportInABrowser, MovesAModelInPlan) {
  const CaseResult result = testing_report::plan_result();
  write_report_html(result, result_charts(result), folder);
  expect_to_move(result);
}

TEST_F(ReportInABrowser, ShowsAStudy) {
  const Chart curve{
      .title = "Pounding", .x_label = "gap [cm]", .y_label = "1", .series = {{"", {0.0, 1.0}, {0.0, 1.0}}}};
  write_study_report({.title = "Study", .answers = {"An answer."}, .pictures = {{"Pounding", svg_text({curve})}}},
                     folder);
  open_everywhere([](const nlohmann::json&) {});
}

// All texts at once: in title, names, quantities, warnings, studies and sheets.
TEST_F(ReportInABrowser, RunsNoScriptOfAName) {
  std::string all;
  for (const std::string& text : testing::hostile_strings())
    if (text.size() < 1000) all += text + " ";
  CaseResult result = testing_report::line_result();
  result.title = all;
  result.warnings.push_back(all);
  for (Peak& peak : result.peaks) peak.where += all;
  for (Column& column : result.histories.columns)
    if (column.quantity != "time") column.where += all;
  write_report_html(result, result_charts(result), folder);
  const auto expect_text = [](const nlohmann::json& verdict) {
    EXPECT_EQ(verdict["problems"], nlohmann::json::array());
    EXPECT_NE(verdict["title"], "XSS");
  };
  expect_text(open(1280, false));
  fs::remove(folder / "report.html");
  write_study_report({.title = all, .answers = {all}}, folder);
  expect_text(open(1280, false));
  write_design_sheets({DesignSheet{.name = all, .code = all, .notes = {all}}}, folder / "report.html");
  expect_text(open(1280, false));
}

TEST_F(ReportInABrowser, RefusesScriptsThatAreNotItsOwn) {
  const std::string page = html::page("A page", "<script>document.title = 'XSS';</script>");
  std::ofstream{folder / "report.html"} << page << "<img src=x onerror=\"document.title='XSS'\"></html>";
  const nlohmann::json verdict = open(1280, false);
  EXPECT_EQ(verdict["title"], "A page");
  EXPECT_GE(verdict["problems"].size(), 1U) << verdict;
}

}  // namespace
}  // namespace moat
