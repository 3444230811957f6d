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
    exhibit.table({"On the page alone", {"c", "d"}, {{"4", "5"}}});
    exhibit.documented_table({"Caption", {"a", "b"}, {{"1|2", "3"}}});
    exhibit.figure(
        {"curve",
         "A curve.",
         {{.title = "t", .x_label = "x", .y_label = "y", .series = {{.name = "s", .x = {0, 1}, .y = {0, 1}}}}}});
    exhibit.assert_that(true, "one is one");
    exhibit.assert_that(held, "two is three");
    exhibit.report(4);
    exhibit.finding({"1.2", "a claim", "a criterion", "a number", Verdict::partly});
    exhibit.finding({"1.3", "another", "a criterion", "many numbers", Verdict::fails, "few numbers"});
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
        "did not hold</span> two is three", "<td>a claim</td>", "<td class=\"partly\">partly", "example_source.cpp",
        "<caption>On the page alone", "<caption>Caption", "<td>many numbers</td>"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  for (const char* part : {"<img", "<?xml", "<script", "<link"}) EXPECT_EQ(page.find(part), std::string::npos) << part;
}

TEST_F(ExhibitInFolder, DocumentsTheTablesMeantForItAndTheFindingsInShort) {
  const std::string text = documentation(example(true));
  EXPECT_NE(text.find("### An <example>"), std::string::npos) << text;
  EXPECT_NE(text.find("**Caption**\n\n| a | b |\n| --- | --- |\n| 1\\|2 | 3 |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("| 1.2 | a claim | a number | partly |\n| 1.3 | another | few numbers | does not hold |"),
            std::string::npos)
      << text;
  for (const char* part : {"On the page alone", "Text & more.", "A curve.", "a criterion", "many numbers"})
    EXPECT_EQ(text.find(part), std::string::npos) << part;
}

TEST_F(ExhibitInFolder, IsMissingInTheDocumentationWithoutTablesUnlessAnAssertionFailed) {
  Exhibit exhibit{folder, "example", "An example", "example_source", false};
  exhibit.table({"On the page alone", {"c", "d"}, {{"4", "5"}}});
  exhibit.assert_that(true, "one is one");
  EXPECT_EQ(exhibit.markdown(), "");
  exhibit.assert_that(false, "two is three");
  EXPECT_NE(exhibit.markdown().find("- Did not hold: two is three"), std::string::npos) << exhibit.markdown();
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
