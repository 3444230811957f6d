// A run keeps all that disk and memory have room for.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "app/results.hpp"
#include "run_program.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::ProgramResult;
using testing::text_of;

constexpr std::array most_important_first{"summary.json", "peaks.csv",     "impacts.csv", "histories.csv",
                                          "report.html",  "histories.vtt", "charts"};

// The names in "Kept: a, b." or "Left out: a, b."
std::vector<std::string> names_behind(const std::string& title, const std::string& text) {
  std::vector<std::string> names;
  const std::size_t begin = text.find(title);
  if (begin == std::string::npos) return names;
  std::string list = text.substr(begin + title.size());
  list = list.substr(0, std::min(list.find(". "), list.find(".\n")));
  std::istringstream words{list};
  for (std::string word; words >> word;) names.push_back(word.substr(0, word.find(',')));
  return names;
}

class KeptResults : public testing::InTemporaryFolder {
 protected:
  // A kilobyte is 1024 bytes. As on a full disk, writing a longer file fails.
  ProgramResult with_files_up_to(std::size_t kilobytes, const std::string& options) {
    return testing::run_program(
        "/bin/bash",
        {"-c", "ulimit -f " + std::to_string(kilobytes) + "; exec " + FIRST_TOUR + " --end '4 s' " + options}, folder);
  }
  fs::path out() const { return folder / "results/01_moat_wall"; }
};

TEST_F(KeptResults, OfAFullDiskAreTheMostImportantFiles) {
  ASSERT_EQ(with_files_up_to(1 << 20, "").exit_code, 0);
  fs::rename(out(), folder / "whole");
  int incomplete = 0;
  for (const std::size_t kilobytes : {10, 20, 40, 100, 200, 300, 500, 700}) {
    SCOPED_TRACE(kilobytes);
    std::size_t too_long = 0;
    for (const char* name :
         {"summary.json", "peaks.csv", "impacts.csv", "histories.csv", "report.html", "histories.vtt"})
      too_long += fs::file_size(folder / "whole" / name) > 1024 * kilobytes ? 1 : 0;
    const ProgramResult result = with_files_up_to(kilobytes, "");
    // First, so that a disk without any room leaves them at least.
    EXPECT_NE(result.output.find("peak displacement [cm]"), std::string::npos) << result.output;
    EXPECT_EQ(result.exit_code, too_long > 0 ? 1 : 0) << result.errors;
    EXPECT_FALSE(fs::exists(out() / "unfinished"));
    if (too_long > 0) {
      ++incomplete;
      EXPECT_FALSE(fs::exists(out() / "frames"));
      EXPECT_FALSE(fs::exists(out() / "frames.pvd"));
      const std::vector<std::string> kept = names_behind("Kept: ", result.errors),
                                     missing = names_behind("Left out: ", result.errors);
      EXPECT_NE(std::ranges::find(missing, "frames"), missing.end()) << result.errors;
      for (const char* name : most_important_first) {
        const bool is_kept = std::ranges::find(kept, name) != kept.end();
        EXPECT_NE(is_kept, std::ranges::find(missing, name) != missing.end()) << name << ": " << result.errors;
        EXPECT_EQ(fs::exists(out() / name), is_kept) << name << result.errors;
      }
      for (const char* name : {"impacts.csv", "histories.csv"}) {
        const std::string whole = text_of(folder / "whole" / name);
        ASSERT_EQ(fs::exists(out() / name), whole.size() <= 1024 * kilobytes) << name << result.errors;
        EXPECT_EQ(fs::exists(out() / name) ? text_of(out() / name) : whole, whole) << name;
      }
      if (fs::exists(out() / "summary.json")) {
        const std::string warning = json::parse(text_of(out() / "summary.json")).at("warnings").at(0);
        EXPECT_TRUE(warning.starts_with("Files of these results are missing: ")) << warning;
      }
    }
    fs::remove_all(folder / "results");
  }
  EXPECT_GT(incomplete, 4);
}

// Any file may be the one that cannot be written.
TEST_F(KeptResults, AreAllButTheFileInTheWay) {
  CaseResult result;
  result.histories.columns = {{"time", "", "s", {0.0, 1.0}}, {"tilt", "body", "m", {0.0, 1.0}}};
  result.offered = {{"tilt", "body", "m"}};  // a chart
  for (const char* blocked : most_important_first) {
    fs::remove_all(folder);
    for (const char* old : {"frames/frame_000000.vtu", "frames.pvd", "moat.py", "checkpoint"}) {
      fs::create_directories((folder / old).parent_path());
      std::ofstream{folder / old} << "old";
    }
    const bool is_folder = std::string{blocked} == "charts";  // which would be removed
    fs::create_directories(folder / (is_folder ? "charts.svg" : blocked) / "inside");
    const std::string sentence = keep_results(result, folder);
    const std::vector<std::string> kept = names_behind("Kept: ", sentence + "\n"),
                                   missing = names_behind("Left out: ", sentence + "\n");
    for (const char* old : {"frames", "frames.pvd", "moat.py"}) EXPECT_FALSE(fs::exists(folder / old)) << old;
    EXPECT_TRUE(fs::exists(folder / "checkpoint")) << "from which the run goes on once there is room";
    EXPECT_EQ(missing, (std::vector<std::string>{"frames", blocked})) << sentence;
    EXPECT_EQ(kept.size(), most_important_first.size() - 1) << sentence;
    for (const std::string& name : kept) EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
}

TEST_F(KeptResults, OfALackOfMemoryReachToTheLastStep) {
  std::size_t rows = 0;
  for (const char* steps : {"10", "60"}) {
    setenv("MOAT_TEST_MEMORY", steps, 1);
    const ProgramResult result = testing::run_program(OBSERVER_SCRIPT, {"--out", steps}, folder);
    unsetenv("MOAT_TEST_MEMORY");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.errors.find("moat: error: There is not enough memory."), std::string::npos) << result.errors;
    const std::string warning = json::parse(text_of(folder / steps / "summary.json")).at("warnings").at(0);
    EXPECT_TRUE(warning.starts_with("The analysis stopped at ")) << warning;
    const std::string histories = text_of(folder / steps / "histories.csv");
    const auto now = static_cast<std::size_t>(std::count(histories.begin(), histories.end(), '\n'));
    EXPECT_GT(now, rows + 5);
    rows = now;
    EXPECT_FALSE(fs::exists(folder / steps / "unfinished"));
  }
}

}  // namespace
}  // namespace moat
