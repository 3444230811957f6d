// Programs whose standard streams are closed, as daemons and some systems of jobs start them.

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

#include "run_program.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing::ProgramResult;

class ClosedStreams : public testing::InTemporaryFolder {
 protected:
  /// streams: bit i closes descriptor i.
  ProgramResult run(int streams, const std::string& command) {
    std::string line = "exec " + command;
    for (int i = 0; i < 3; ++i)
      if ((streams >> i & 1) != 0) line += " " + std::to_string(i) + (i == 0 ? "<&-" : ">&-");
    return testing::run_program("/bin/sh", {"-c", line}, folder);
  }
  /// All files whose contents do not depend on time.
  std::map<std::string, std::string> files_in(const fs::path& path) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator{path})
      if (entry.is_regular_file() && entry.path().extension() != ".json" && entry.path().extension() != ".html" &&
          entry.path().extension() != ".db" && entry.path().filename() != "study.csv")
        files[entry.path().lexically_relative(path).string()] = testing::read_file(entry.path());
    return files;
  }
  void expect_same_files(const std::string& command) {
    EXPECT_EQ(run(0, command).exit_code, 0);
    fs::rename(folder / "out", folder / "open");
    for (int streams = 1; streams < 8; ++streams) {
      SCOPED_TRACE(command + ", closed: " + std::to_string(streams));
      const ProgramResult result = run(streams, command);
      EXPECT_EQ(result.exit_code, 0) << result.errors;
      EXPECT_EQ(files_in(folder / "out"), files_in(folder / "open"));
      fs::remove_all(folder / "out");
    }
    fs::remove_all(folder / "open");
  }
};

TEST_F(ClosedStreams, LeaveTheFilesOfRunsAndStudiesAsTheyAre) {
  expect_same_files(std::string{FIRST_TOUR} + " --end '0.5 s' --out out");
  expect_same_files(std::string{STUDY_SCRIPT} + " --gaps 2 --out out");
}

TEST_F(ClosedStreams, LeaveTheFilesOfCommandsAsTheyAre) {
  std::ofstream{folder / "record.AT2"}
      << "A\nB\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 4, DT= .1 SEC\n0 .1 -.1 0\n";
  expect_same_files(std::string{MOTION_COMMAND} + " record.AT2 --out out");
}

}  // namespace
}  // namespace moat
