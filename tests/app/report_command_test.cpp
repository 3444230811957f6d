// The command `moat report`.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace moat {
namespace {

using nlohmann::json;
using testing::ProgramResult;
using testing::text_of;

class ReportCommand : public testing::InTemporaryFolder {
 protected:
  ProgramResult report(std::vector<std::string> arguments) {
    return testing::run_program(REPORT_COMMAND, std::move(arguments), folder);
  }
  void run_tour() {
    const ProgramResult run =
        testing::run_program(FIRST_TOUR, {"--end", "4 s", "--frame-interval", "0 s", "--out", "out"}, folder);
    ASSERT_EQ(run.exit_code, 0) << run.errors;
  }
};

TEST_F(ReportCommand, ShowsARunOnOneScreen) {
  run_tour();
  const ProgramResult result = report({"out"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  for (const char* text : {"Five-storey isolated building inside a moat", "PGA 0.4 g", "peak displacement [cm]",
                           "smallest clearance left", "impact", "The whole report: out/report.html"})
    EXPECT_NE(result.output.find(text), std::string::npos) << text << "\n" << result.output;
  EXPECT_LT(std::count(result.output.begin(), result.output.end(), '\n'), 40) << result.output;
}

TEST_F(ReportCommand, JsonHasTheLargestPeakOfEveryQuantity) {
  run_tour();
  const json summary = json::parse(text_of(folder / "out/summary.json"));
  const ProgramResult result = report({"out", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json printed = json::parse(result.output);
  EXPECT_EQ(printed.at("title"), summary.at("title"));
  EXPECT_EQ(printed.at("impacts"), summary.at("impacts"));
  EXPECT_EQ(printed.at("report"), "out/report.html");
  for (const json& largest : printed.at("largest_peaks"))
    for (const json& peak : summary.at("peaks"))
      if (peak.at("quantity") == largest.at("quantity")) {
        EXPECT_LE(std::abs(peak.at("value").get<double>()), std::abs(largest.at("value").get<double>())) << peak;
      }
  for (const json& gap : summary.at("clearances"))
    EXPECT_GE(gap.at("clearance_left"), printed.at("smallest_clearance").at("clearance_left")) << gap;
}

TEST_F(ReportCommand, ShowsStudies) {
  ASSERT_NE(testing::run_program(STUDY_SCRIPT, {"--out", "out"}, folder).exit_code, 2);
  const ProgramResult result = report({"out"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.output.find("study.db"), std::string::npos) << result.output;
  const json study = json::parse(report({"out", "--json"}).output).at("studies").at(0);
  EXPECT_EQ(study.at("file"), "study.db");
  EXPECT_EQ(study.at("cases").get<int>(), study.at("done").get<int>() + study.at("not_converged").get<int>() +
                                              study.at("failed").get<int>() + study.at("open").get<int>());
  EXPECT_EQ(study.at("failures").size(),
            study.at("failed").get<std::size_t>() + study.at("not_converged").get<std::size_t>());
}

TEST_F(ReportCommand, OpensThePageWithTheBrowserOfTheDesktop) {
  run_tour();
  std::ofstream{folder / "xdg-open"} << "#!/bin/sh\necho \"opened $1\"\n";
  std::filesystem::permissions(folder / "xdg-open", std::filesystem::perms::owner_all);
  const auto with_path = [&](const std::string& path) {
    return testing::run_program("/usr/bin/env", {"PATH=" + path, REPORT_COMMAND, "out", "--open"}, folder);
  };
  const ProgramResult opened = with_path(folder.string() + ":/usr/bin:/bin");
  EXPECT_EQ(opened.exit_code, 0) << opened.errors;
  EXPECT_NE(opened.output.find("opened " + (folder / "out/report.html").string()), std::string::npos) << opened.output;
  const ProgramResult none = with_path((folder / "nothing").string());
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_NE(none.errors.find("in a browser"), std::string::npos) << none.errors;
}

TEST_F(ReportCommand, RefusesAFolderWithoutResults) {
  EXPECT_NE(report({"nowhere"}).errors.find("there is no such folder"), std::string::npos);
  const ProgramResult empty = report({"."});
  EXPECT_EQ(empty.exit_code, 1);
  EXPECT_NE(empty.errors.find("there are no results here"), std::string::npos) << empty.errors;
  std::ofstream{folder / "summary.json"} << "{ \"title\": \"cut";
  EXPECT_NE(report({"."}).errors.find("this is not the summary of a run"), std::string::npos);
  std::ofstream{folder / "summary.json"} << "{}";
  EXPECT_NE(report({"."}).errors.find("this is not the summary of a run"), std::string::npos);
  EXPECT_EQ(report({}).exit_code, 2);
}

}  // namespace
}  // namespace moat
