// A single run that is stopped by a signal keeps everything up to then.

#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>
#include <tuple>

#include "run_program.hpp"

namespace moat {
namespace {

using nlohmann::json;

class StoppedRun : public testing::InTemporaryFolder {
 protected:
  // Steps so short that the run would take minutes.
  testing::ProgramResult stopped_by(int signal, std::vector<std::string> more = {}, int times = 1) {
    std::vector<std::string> arguments{"--step", "1e-6 s", "--end", "30 s", "--frame-interval", "0.01 s"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const testing::RunningProgram run{FIRST_TOUR, arguments, folder};
    // The first frame stands in its place once the run has begun.
    const auto begun = [&] {
      return std::filesystem::exists(folder / "results/01_moat_wall/frames") ||
             std::filesystem::exists(folder / "results/01_moat_wall.new/frames");
    };
    while (!begun()) std::this_thread::sleep_for(std::chrono::milliseconds{5});
    std::this_thread::sleep_for(std::chrono::milliseconds{200});
    for (int i = 0; i < times; ++i) run.send(signal);
    return run.wait();
  }
};

TEST_F(StoppedRun, WritesAllResultsUpToThen) {
  for (const auto& [signal, name, code] :
       {std::tuple{SIGINT, "SIGINT", 130}, {SIGTERM, "SIGTERM", 143}, {SIGHUP, "SIGHUP", 129}}) {
    std::filesystem::remove_all(folder / "results");
    // A shell whose terminal is closed sends SIGHUP, and so does the kernel.
    const testing::ProgramResult result = stopped_by(signal, {}, signal == SIGHUP ? 3 : 1);
    EXPECT_EQ(result.exit_code, code) << result.errors;
    EXPECT_NE(result.errors.find(name + std::string{". To compute the whole: "}), std::string::npos) << result.errors;
    EXPECT_NE(result.errors.find("--step '1e-6 s'"), std::string::npos) << result.errors;
    const json summary = json::parse(testing::text_of(folder / "results/01_moat_wall/summary.json"));
    const std::string first_warning = summary.at("warnings").at(0);
    EXPECT_TRUE(first_warning.starts_with("The analysis stopped at ")) << first_warning;
    EXPECT_FALSE(std::filesystem::exists(folder / "results/01_moat_wall/unfinished"));
    for (const char* file : {"histories.csv", "histories.vtt", "impacts.csv", "report.html", "frames.pvd"})
      EXPECT_TRUE(std::filesystem::exists(folder / "results/01_moat_wall" / file)) << file;
    EXPECT_NE(testing::text_of(folder / "results/01_moat_wall/report.html").find("The analysis stopped at"),
              std::string::npos);
  }
}

TEST_F(StoppedRun, ThatWasToOverwriteLeavesTheOldResultsAndTakesANewNumber) {
  const std::filesystem::path old = folder / "results/01_moat_wall", partial = folder / "results/01_moat_wall_2";
  ASSERT_EQ(testing::run_program(FIRST_TOUR, {"--end", "0.1 s", "--frame-interval", "0 s"}, folder).exit_code, 0);
  const std::string summary = testing::text_of(old / "summary.json");
  const testing::ProgramResult result = stopped_by(SIGINT, {"--force"});
  EXPECT_EQ(result.exit_code, 130) << result.errors;
  EXPECT_EQ(testing::text_of(old / "summary.json"), summary);
  EXPECT_FALSE(std::filesystem::exists(old / "frames"));
  EXPECT_NE(testing::text_of(partial / "report.html").find("The analysis stopped at"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(partial / "frames"));
  EXPECT_FALSE(std::filesystem::exists(folder / "results/01_moat_wall.new"));
  EXPECT_NE(result.errors.find("moat: The old results in results/01_moat_wall stay; those of this run are in "
                               "results/01_moat_wall_2.\n"),
            std::string::npos)
      << result.errors;
  EXPECT_NE(result.output.find("Results: results/01_moat_wall_2/"), std::string::npos) << result.output;
}

// As nohup starts it.
TEST_F(StoppedRun, GoesOnAtASignalThatItWasStartedToIgnore) {
  const testing::RunningProgram run{
      "/bin/sh", {"-c", std::string{"trap '' HUP; exec "} + FIRST_TOUR + " --step '1e-5 s' --end '2 s'"}, folder};
  while (!std::filesystem::exists(folder / "results/01_moat_wall/frames"))
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  run.send(SIGHUP);
  const testing::ProgramResult result = run.wait();
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.errors.find("SIGHUP"), std::string::npos) << result.errors;
}

TEST_F(StoppedRun, ThatIsKilledIsUnfinishedAndTheReportSaysSo) {
  EXPECT_EQ(stopped_by(SIGKILL, {"--gap", "11 cm"}).exit_code, -1);
  const std::string mark = testing::text_of(folder / "results/01_moat_wall/unfinished");
  EXPECT_NE(mark.find("--gap '11 cm'"), std::string::npos) << mark;
  const testing::ProgramResult report = testing::run_program(REPORT_COMMAND, {"results/01_moat_wall"}, folder);
  EXPECT_EQ(report.exit_code, 1);
  EXPECT_NE(report.errors.find("unfinished"), std::string::npos) << report.errors;
  EXPECT_NE(report.errors.find("--gap '11 cm'"), std::string::npos) << report.errors;
  // A folder that was killed while its results were exchanged has both.
  ASSERT_EQ(testing::run_program(FIRST_TOUR, {"--end", "0.1 s", "--out", "whole"}, folder).exit_code, 0);
  std::filesystem::copy_file(folder / "results/01_moat_wall/unfinished", folder / "whole/unfinished");
  const testing::ProgramResult both = testing::run_program(REPORT_COMMAND, {"whole"}, folder);
  EXPECT_EQ(both.exit_code, 0) << both.errors;
  EXPECT_NE(both.output.find("unfinished"), std::string::npos) << both.output;
  EXPECT_NE(both.output.find("peak displacement"), std::string::npos) << both.output;
}

// head, or a page that its reader leaves: the pipe has no reader when the peaks are printed.
TEST_F(StoppedRun, KeepsItsResultsWhereNobodyReadsItsOutput) {
  const testing::ProgramResult result = testing::run_program(
      "/bin/bash", {"-c", std::string{FIRST_TOUR} + " --end '0.5 s' | true; exit ${PIPESTATUS[0]}"}, folder);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.errors.find("standard output cannot be written"), std::string::npos) << result.errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "results/01_moat_wall/summary.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "results/01_moat_wall/unfinished"));
}

}  // namespace
}  // namespace moat
