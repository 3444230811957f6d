// A single run that is stopped by a signal keeps everything up to then.

#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "run_program.hpp"

namespace moat {
namespace {

using nlohmann::json;

class StoppedRun : public testing::InTemporaryFolder {
 protected:
  // Steps so short that the run would take minutes.
  testing::ProgramResult stopped_by(int signal, std::vector<std::string> more = {}) {
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
    run.send(signal);
    return run.wait();
  }
};

TEST_F(StoppedRun, WritesAllResultsUpToThen) {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}}) {
    std::filesystem::remove_all(folder / "results");
    const testing::ProgramResult result = stopped_by(signal);
    EXPECT_EQ(result.exit_code, code) << result.errors;
    EXPECT_NE(result.errors.find(code == 130 ? "SIGINT. To compute the whole: " : "SIGTERM. To compute the whole: "),
              std::string::npos)
        << result.errors;
    EXPECT_NE(result.errors.find("--step '1e-6 s'"), std::string::npos) << result.errors;
    const json summary = json::parse(testing::text_of(folder / "results/01_moat_wall/summary.json"));
    const std::string first_warning = summary.at("warnings").at(0);
    EXPECT_TRUE(first_warning.starts_with("The analysis stopped at ")) << first_warning;
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

}  // namespace
}  // namespace moat
