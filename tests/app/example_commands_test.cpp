// The commands that the help of the launcher and the heads of the tours show are run as they stand there.

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace moat {
namespace {

// A tour and the options behind it, as a shell would read them.
struct ExampleCommand {
  std::string tour, options;
};

// Lines that begin with `prefix` and run a tour. Two blanks and a text may follow the command.
std::vector<ExampleCommand> commands_in(const std::string& text, const std::string& prefix) {
  const std::string beginning = prefix + "./moat run examples/";
  std::vector<ExampleCommand> commands;
  std::istringstream stream{text};
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(beginning)) continue;
    const std::string command = line.substr(beginning.size(), line.find("  ", beginning.size()) - beginning.size());
    const std::size_t suffix = command.find(".cpp");
    commands.push_back({command.substr(0, suffix), command.substr(suffix + 4)});
  }
  return commands;
}

class ExampleCommands : public testing::InTemporaryFolder {
 protected:
  void expect_runs(const ExampleCommand& command) const {
    const std::filesystem::path program = std::filesystem::path{FIRST_TOUR}.parent_path() / command.tour;
    const testing::ProgramResult result =
        testing::run_program("/bin/bash", {"-c", "\"$0\"" + command.options, program.string()}, folder);
    EXPECT_EQ(result.exit_code, 0) << command.tour << command.options << "\n" << result.errors;
  }
};

TEST_F(ExampleCommands, OfTheLaunchersHelpRun) {
  std::size_t found = 0;
  for (const char* command : {"", "run", "new", "test", "bench", "study", "doctor"}) {
    std::vector<std::string> arguments{MOAT_SOURCE_DIR, folder / "build", folder, command, "--help"};
    if (*command == '\0') arguments.erase(arguments.begin() + 3);
    const testing::ProgramResult help = testing::run_program(LAUNCHER, arguments, folder);
    ASSERT_EQ(help.exit_code, 0) << help.errors;
    for (const ExampleCommand& example : commands_in(help.output, "  ")) {
      expect_runs(example);
      ++found;
    }
  }
  EXPECT_GE(found, 5u);
}

TEST_F(ExampleCommands, OfTheToursRun) {
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::directory_iterator{MOAT_SOURCE_DIR "/examples"}) {
    if (entry.path().extension() != ".cpp") continue;
    for (const ExampleCommand& example : commands_in(testing::text_of(entry.path()), "//     ")) {
      if (example.options.find("RECORD") == std::string::npos) expect_runs(example);  // which nobody may redistribute
      ++found;
    }
  }
  EXPECT_GE(found, 15u);
}

}  // namespace
}  // namespace moat
