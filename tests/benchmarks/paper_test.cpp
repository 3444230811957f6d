// The benchmark as it is run: its assertions hold, and its page opens in a browser.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

#include "in_folder.hpp"

namespace moat::paper {
namespace {

bool have_records() {
  const char* folder = std::getenv("MOAT_RECORDS");
  return folder != nullptr && *folder != '\0';
}

class Paper : public InFolder {
 protected:
  /// Runs a command of the shell; its output goes to out.txt and err.txt in the test's folder.
  int run(const std::string& command) const {
    const int status =
        std::system((command + " >" + file("out.txt") + " 2>" + file("err.txt") + " </dev/null").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string file(const std::string& name) const { return "'" + (folder / name).string() + "'"; }
  [[nodiscard]] static std::string program() { return "'" MOAT_PAPER_PROGRAM "'"; }
};

TEST_F(Paper, Table1Holds) {
  EXPECT_EQ(run(program() + " --only table1 --out " + file("page")), 0) << text_of("err.txt");
  EXPECT_NE(text_of("page/index.html").find("within 0.006"), std::string::npos);
}

TEST_F(Paper, Table2Holds) {
  if (!have_records()) GTEST_SKIP() << "set MOAT_RECORDS to a folder with PEER AT2 files to run this test";
  EXPECT_EQ(run(program() + " --only table2 --out " + file("page")), 0) << text_of("err.txt");
  const std::string page = text_of("page/index.html");
  if (page.find("Skipped: ") != std::string::npos)
    GTEST_SKIP() << "the folder of MOAT_RECORDS lacks records of the paper";
  EXPECT_NE(page.find("within 8 % of the paper's"), std::string::npos);
}

TEST_F(Paper, WithoutRecordsSaysHowMuchIsSkippedAndWhereToGetThem) {
  EXPECT_EQ(run("env -u MOAT_RECORDS " + program() + " --coarse --out " + file("page")), 0) << text_of("err.txt");
  const std::string out = text_of("out.txt");
  EXPECT_NE(out.find("Skipped: 9 of 11 tables and figures. MOAT_RECORDS is not set."), std::string::npos) << out;
  EXPECT_NE(out.find("RSN 1161, 1108, 982 and 803"), std::string::npos) << out;
  EXPECT_NE(out.find("ngawest2.berkeley.edu"), std::string::npos) << out;
  EXPECT_TRUE(out.ends_with("30 asserted, 30 held, 30 reported\n")) << out;
}

TEST_F(Paper, WritesNoDocumentationWithoutRecords) {
  EXPECT_EQ(run("env -u MOAT_RECORDS " + program() + " --write-docs --out " + file("page")), 1);
  EXPECT_NE(text_of("err.txt").find("--write-docs needs the records"), std::string::npos) << text_of("err.txt");
}

/// Put at the end of the page: for every figure its size and how many labels stick out of it.
constexpr const char* look = R"(<script>
let lines = ['images ' + [...document.images].filter(i => !i.naturalWidth).length + ' broken'];
for (const figure of document.querySelectorAll('figure')) {
  const box = figure.querySelector('svg').getBoundingClientRect();
  const outside = [...figure.querySelectorAll('text')].filter(t => { const b = t.getBoundingClientRect();
    return b.left < box.left - 1 || b.right > box.right + 1 || b.top < box.top - 1 || b.bottom > box.bottom + 1; });
  lines.push('figure ' + figure.id + ' ' + Math.round(box.width) + ' x ' + Math.round(box.height) + ' texts ' +
    figure.querySelectorAll('text').length + ' outside ' + outside.length);
}
document.write('<pre id="seen">\n' + lines.join('\n') + '\nend</pre>');
</script>)";

TEST_F(Paper, PageOpensInABrowserWithEveryFigure) {
  if (run("command -v chromium") != 0) GTEST_SKIP() << "the browser chromium is not installed";
  ASSERT_EQ(run(program() + " --coarse --out " + file("page")), 0) << text_of("err.txt");
  std::string page = text_of("page/index.html");
  page.insert(page.rfind("</body>"), look);
  std::ofstream{folder / "page/looked_at.html"} << page;
  ASSERT_EQ(
      run("chromium --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking "
          "--disable-component-update --disable-sync --enable-logging=stderr --window-size=1100,900 --user-data-dir=" +
          file("browser") + " --dump-dom " + file("page/looked_at.html")),
      0)
      << text_of("err.txt");

  // The browser complains about its own surroundings too; only messages of the page on the console count.
  EXPECT_EQ(text_of("err.txt").find(":CONSOLE"), std::string::npos) << text_of("err.txt");
  const std::string seen = text_of("out.txt");
  EXPECT_NE(seen.find("images 0 broken"), std::string::npos);
  std::vector<std::string> expected{"table1", "pulse"};
  if (std::filesystem::exists(folder / "page/fig6.svg"))
    expected.insert(expected.end(),
                    {"fig4", "fig5", "fig6", "fig7", "fig8", "fig9", "fig10", "fig10_designed", "fig11"});
  else
    EXPECT_FALSE(have_records());
  for (const std::string& figure : expected) {
    std::smatch match;
    const std::regex line{"figure " + figure + " (\\d+) x (\\d+) texts (\\d+) outside (\\d+)"};
    ASSERT_TRUE(std::regex_search(seen, match, line)) << figure << " is not shown";
    EXPECT_GE(std::stoi(match[1]), 900) << figure << " is too narrow";
    EXPECT_GE(std::stoi(match[2]), 250) << figure << " is too low";
    EXPECT_GE(std::stoi(match[3]), 8) << figure << " lacks labels";
    EXPECT_EQ(std::stoi(match[4]), 0) << figure << " has clipped labels";
  }
}

}  // namespace
}  // namespace moat::paper
