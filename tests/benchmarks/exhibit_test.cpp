// The output of the benchmark, and its counts.

#include "paper/exhibit.hpp"

#include "in_folder.hpp"
#include "message_of.hpp"
#include "paper/printed_table.hpp"

namespace moat::paper {
namespace {

class ExhibitInFolder : public InFolder {
 protected:
  /// One exhibit that shows something of every kind.
  [[nodiscard]] std::vector<Exhibit> example(bool held) const {
    Exhibit exhibit{folder, "example", "An <example>", "example_source", false};
    exhibit.text("Text & more.");
    exhibit.table({"Caption", {"a", "b"}, {{"1|2", "3"}}});
    exhibit.figure(
        {"curve",
         "A curve.",
         {{.title = "t", .x_label = "x", .y_label = "y", .series = {{.name = "s", .x = {0, 1}, .y = {0, 1}}}}}});
    exhibit.assert_that(true, "one is one");
    exhibit.assert_that(held, "two is three");
    exhibit.report(4);
    exhibit.finding({"1.2", "a claim", "a criterion", "a number", Verdict::partly});
    return {exhibit};
  }
};

TEST_F(ExhibitInFolder, CountsWhatIsAssertedAndWhatHolds) {
  const Totals totals = totals_of(example(false));
  EXPECT_EQ(totals.asserted, 2u);
  EXPECT_EQ(totals.held, 1u);
  EXPECT_EQ(totals.reported, 4u);
  EXPECT_EQ(totals.skipped, 0u);
}

TEST_F(ExhibitInFolder, MakesAPageThatNeedsNoOtherFile) {
  write_page(folder, example(false));
  const std::string page = text_of("index.html");
  for (const char* part :
       {"2 asserted, 1 held, 4 reported", "An &lt;example&gt;", "Text &amp; more.", "<figure id=\"curve\">", "<svg",
        "did not hold</span> two is three", "<td>a claim</td>", "<td class=\"partly\">partly", "example_source.cpp"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  for (const char* part : {"<img", "<?xml", "<script", "<link"}) EXPECT_EQ(page.find(part), std::string::npos) << part;
}

TEST_F(ExhibitInFolder, WritesTablesAsMarkdown) {
  const std::string text = documentation(example(true));
  EXPECT_NE(text.find("| a | b |\n| --- | --- |\n| 1\\|2 | 3 |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("| 1.2 | a claim | a criterion | a number | partly |"), std::string::npos) << text;
}

TEST_F(ExhibitInFolder, SaysOnThePageThatItFailed) {
  std::vector<Exhibit> exhibits = example(true);
  exhibits.front().failure = "no memory";
  write_page(folder, exhibits);
  EXPECT_NE(text_of("index.html").find("no memory"), std::string::npos);
}

TEST(PrintedTable, HasTheTenRowsOfTable1) {
  const std::vector<PrintedRow> rows = printed_table("table1.csv");
  ASSERT_EQ(rows.size(), 10u);
  EXPECT_EQ(number(rows[4], "e_hertz_damp"), 0.7250);
  EXPECT_NE(testing::message_of<Error>([&] { (void)number(rows[0], "mass"); }).find("column mass"), std::string::npos);
  EXPECT_NE(testing::message_of<FileError>([] { (void)printed_table("none.csv"); }).find("none.csv"),
            std::string::npos);
}

}  // namespace
}  // namespace moat::paper
