// The report of studies.

#include "study/study_report.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "message_of.hpp"
#include "run_program.hpp"

namespace moat {
namespace {

using testing::text_of;

class StudyReportFile : public testing::InTemporaryFolder {
 protected:
  std::string page(const StudyReport& report) {
    write_study_report(report, folder);
    return text_of(folder / "report.html");
  }
  bool has(const std::string& picture) const {
    return std::filesystem::exists(folder / "pictures" / (picture + ".svg"));
  }
  /// Two axes; the last case is open, and one did not converge.
  static StudyResult study() {
    const StudyCases cases{{.name = "gap", .unit = "cm", .values = {10.0, 20.0, 30.0}},
                           {.name = "yield force", .unit = "MN", .values = {1.0, 2.0, 3.0}}};
    std::vector<CaseOutcome> outcomes(cases.count());
    for (std::size_t i = 0; i + 1 < outcomes.size(); ++i)
      outcomes[i] = {.state = CaseState::done,
                     .results = {{"drift", "storey 1", "m", 0.01}, {"impacts", "", "1", static_cast<double>(i % 3)}}};
    outcomes[4] = {.state = CaseState::not_converged, .reason = "stuck"};
    return {cases, outcomes};
  }
};

TEST_F(StudyReportFile, ShowsPoundingFirst) {
  const std::string html = page({.title = "A study", .studies = {{"fine", study()}}});
  const std::size_t map = html.find("Impacts"), drift = html.find("Largest drift");
  ASSERT_NE(map, std::string::npos);
  EXPECT_LT(map, drift);
  for (const char* text : {"of these done", "of these open", "Case 4, gap = 20 cm, yield force = 2 MN", "stuck"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
}

TEST_F(StudyReportFile, WritesEveryPictureAsAFileOfItsOwn) {
  page({.title = "A study", .studies = {{"fine", study()}}});
  for (const char* name : {"fine_impacts_map", "fine_largest_drift_map", "fine_impacts_over_gap",
                           "fine_impacts_over_yield_force", "fine_largest_drift_over_gap"}) {
    ASSERT_TRUE(has(name)) << name;
    EXPECT_TRUE(text_of(folder / "pictures" / (std::string{name} + ".svg")).starts_with("<?xml")) << name;
  }
}

// A study that goes on may have other curves: of another group, or of more records.
TEST_F(StudyReportFile, ReplacesAPictureTogetherWithItsTable) {
  const auto picture = [](const std::string& curve, double y) {
    const Chart chart{.title = "Drift",
                      .x_label = "x [m]",
                      .y_label = "y [m]",
                      .series = {{.name = curve, .x = {0, 1}, .y = {0, y}}}};
    return StudyPicture{"Drift", svg_text({chart}), table_of(chart)};
  };
  const auto write = [&](const StudyPicture& shown) {
    page({.title = "A study", .pictures = {shown}, .studies = {{"fine", study()}}});
  };
  const std::filesystem::path table = folder / "pictures/drift.csv";
  write(picture("lower", 2.0));
  EXPECT_EQ(text_of(table), "x [m],y [m] lower\n0,0\n1,2\n");
  write(picture("upper", 3.0));
  EXPECT_EQ(text_of(table), "x [m],y [m] upper\n0,0\n1,3\n") << "other curves";
  EXPECT_FALSE(has("drift_2"));
  // A picture without numbers takes the table of its predecessor away.
  write({"Drift", "<svg>drawn</svg>"});
  EXPECT_FALSE(std::filesystem::exists(table));
  EXPECT_FALSE(has("drift_2"));
  // A table of the user beside a picture is none of its own.
  std::ofstream{table} << "my notes\n";
  write(picture("lower", 2.0));
  EXPECT_EQ(text_of(table), "my notes\n");
  EXPECT_TRUE(has("drift_2"));
  write({"Drift", "<svg>drawn</svg>"});
  EXPECT_EQ(text_of(table), "my notes\n");
}

TEST_F(StudyReportFile, IsWrittenWhereATableOfAnotherIsInTheWay) {
  std::ofstream{folder / "first.csv"} << "mine\n";
  const Table table{{{"gap", "", "m", {0.1, 0.2}}}};
  const StudyReport report{
      .title = "A study", .tables = {{"First", table}, {"Second", table}}, .studies = {{"fine", study()}}};
  EXPECT_NE(testing::message_of([&] { write_study_report(report, folder); }).find("first.csv is not this table"),
            std::string::npos);
  EXPECT_EQ(text_of(folder / "first.csv"), "mine\n");
  EXPECT_NE(text_of(folder / "report.html").find("<h3>Second</h3>"), std::string::npos);
  EXPECT_EQ(text_of(folder / "second.csv"), "gap [m]\n0.1\n0.2\n");
}

TEST_F(StudyReportFile, PrefersThePicturesOfTheScript) {
  const StudyPicture automatic{"Fragility", "<svg>automatic</svg>"}, own{"Fragility", "<svg>own</svg>"},
      other{"Other", "<svg>other</svg>"};
  EXPECT_NE(page({.title = "A study", .studies = {{"fine", study(), {}, {automatic}}}}).find("automatic"),
            std::string::npos);
  EXPECT_TRUE(has("fine_fragility"));
  std::ofstream{folder / "pictures" / "holidays.svg"} << "of the user";
  const std::string html =
      page({.title = "A study", .pictures = {own, other, other}, .studies = {{"fine", study(), {}, {automatic}}}});
  EXPECT_EQ(html.find("automatic"), std::string::npos);
  EXPECT_NE(html.find("<svg>own</svg>"), std::string::npos);
  EXPECT_TRUE(has("fragility") && has("other") && has("other_2"));
  EXPECT_FALSE(has("fine_fragility")) << "of an earlier report";
  EXPECT_TRUE(has("holidays")) << "other files stay";
}

}  // namespace
}  // namespace moat
