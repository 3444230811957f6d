// The script of `moat completion bash`, asked by bash itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "base/text/terminal.hpp"
#include "launcher/text.hpp"
#include "run_program.hpp"

namespace moat::launcher {
namespace {

class Completion : public moat::testing::InTemporaryFolder {
 protected:
  Completion() {
    const auto printed = moat::testing::run_program(
        LAUNCHER, {MOAT_SOURCE_DIR, BUILD_FOLDER, folder / "cache", "completion", "bash"}, folder);
    EXPECT_EQ(printed.exit_code, 0) << printed.errors;
    write_text(folder / "completion.bash", printed.output);
  }
  // The words that bash, which asks the launcher for its help, offers behind these; the last one is not complete.
  std::vector<std::string> offered(const std::vector<std::string>& words) const {
    std::string quoted;
    for (const std::string& word : words) quoted += " " + shell_word(word);
    const std::string moat = "moat() { '" LAUNCHER "' '" MOAT_SOURCE_DIR "' '" BUILD_FOLDER "' cache \"$@\"; }\n";
    write_text(folder / "ask.sh", moat + "source completion.bash\nCOMP_WORDS=(moat" + quoted +
                                      ")\nCOMP_CWORD=" + std::to_string(words.size()) +
                                      "\n_moat\nprintf '%s\\n' ${COMPREPLY[@]+\"${COMPREPLY[@]}\"}\n");
    const auto result = moat::testing::run_program("/bin/bash", {"-u", "ask.sh"}, folder);
    EXPECT_EQ(result.errors, "");
    std::vector<std::string> list = lines_of(result.output);
    std::ranges::sort(list);
    return list;
  }
  bool offers(const std::vector<std::string>& words, const std::string& word) const {
    const std::vector<std::string> list = offered(words);
    return std::ranges::find(list, word) != list.end();
  }
};

TEST_F(Completion, OffersCommands) {
  EXPECT_EQ(offered({"re"}), std::vector<std::string>{"report"});
  EXPECT_EQ(offered({"mo"}), std::vector<std::string>{"motion"});
  for (const char* command :
       {"run", "new", "test", "bench", "motion", "report", "study", "check", "fuzz", "completion", "doctor"})
    EXPECT_TRUE(offers({""}, command)) << command;
}

TEST_F(Completion, OffersOptionsOfCommands) {
  EXPECT_EQ(offered({"new", "--p"}), std::vector<std::string>{"--project"});
  EXPECT_EQ(offered({"test", "--a"}), std::vector<std::string>{"--all"});
  EXPECT_EQ(offered({"check", "san"}), std::vector<std::string>{"sanitizers"});
  EXPECT_EQ(offered({"check", "fa"}), std::vector<std::string>{"faults"});
  EXPECT_EQ(offered({"bench", "perf"}), std::vector<std::string>{"performance"});
  EXPECT_EQ(offered({"study", "m"}), std::vector<std::string>{"merge"});
}

TEST_F(Completion, OffersScriptsAndFolders) {
  write_text(folder / "tower.cpp", "");
  write_text(folder / "tower.txt", "");
  std::filesystem::create_directories(folder / "towers");
  EXPECT_EQ(offered({"run", "tow"}), (std::vector<std::string>{"tower.cpp", "towers"}));
  EXPECT_EQ(offered({"motion", "tower.t"}), std::vector<std::string>{"tower.txt"});
}

// The words that the launcher cannot ask a parser for agree with the help of the programs behind them.
TEST_F(Completion, KnowsTheOptionsOfTheLibrarysPrograms) {
  const auto options_in = [&](const char* program) {
    std::vector<std::string> options;
    std::istringstream help{moat::testing::run_program(program, {"--help"}, folder).output};
    for (std::string word; help >> word;)
      if (word.starts_with("--") && word.size() > 2) options.push_back(word.substr(0, word.find_first_of(",=")));
    return options;
  };
  for (const auto& [command, program] :
       {std::pair{"run", FIRST_TOUR}, {"motion", MOTION_COMMAND}, {"report", REPORT_COMMAND}})
    for (const std::string& option : options_in(program))
      if (option != "--gap" && option != "--pga") {
        EXPECT_TRUE(offers({command, "file", option}, option)) << command << " " << option;
      }
}

}  // namespace
}  // namespace moat::launcher
