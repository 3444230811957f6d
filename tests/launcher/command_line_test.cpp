// The program as the bootstrap script calls it, with this build as a library that is not ours to change.

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "base/sha256.hpp"
#include "launcher/text.hpp"
#include "run_program.hpp"

namespace moat::launcher {
namespace {

class CommandLine : public moat::testing::InTemporaryFolder {
 protected:
  moat::testing::ProgramResult launch(const std::vector<std::string>& words) const {
    std::vector<std::string> all{"-u", "MOAT_RECORDS", LAUNCHER, MOAT_SOURCE_DIR, BUILD_FOLDER, folder / "cache"};
    all.insert(all.end(), words.begin(), words.end());
    return moat::testing::run_program("/usr/bin/env", all, folder);
  }
};

TEST_F(CommandLine, ShowsNoControlCharactersOfNames) {
  const std::string name = "\x1b[31m\a\r\x7F.cpp", shown = "\\u001b[31m\\u0007\\u000d\\u007f.cpp";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"run", name}, {name}, {"new", name}, {"run", "--ranks", name}, {"check", name}}) {
    const auto result = launch(words);
    const std::string text = result.output + result.errors;
    EXPECT_EQ(text.find_first_of("\x1b\a\r\x7F"), std::string::npos) << text;
    EXPECT_NE(text.find(shown), std::string::npos) << text;
  }
}

// The words between the blanks of a line.
std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream{line};
  return {std::istream_iterator<std::string>{stream}, {}};
}

TEST_F(CommandLine, ExplainsEveryCommand) {
  for (const char* line : {"--help", "help", "run --help", "new --help", "test --help", "bench --help",
                           "bench paper --help", "study --help", "motion --help", "report --help", "completion --help",
                           "check --help", "fuzz --help", "doctor --help"}) {
    const auto result = launch(words_of(line));
    EXPECT_EQ(result.exit_code, 0) << line;
    EXPECT_EQ(result.errors, "") << line;
    EXPECT_NE(result.output.find("./moat"), std::string::npos) << line;
  }
}

TEST_F(CommandLine, RefusesWrongUsageWithAHint) {
  write_text(folder / "exists.cpp", "");
  write_text(folder / "notes.txt", "");
  for (const std::string line : {"",
                                 "frobnicate",
                                 "--fast",
                                 "run",
                                 "run --fast",
                                 "run no.cpp",
                                 "run notes.txt",
                                 "run .",
                                 "new",
                                 "new exists.cpp",
                                 "new -x.cpp",
                                 "doctor now",
                                 "bench",
                                 "bench tower",
                                 "study",
                                 "study frobnicate",
                                 "new my+tower --project",
                                 "motion",
                                 "report",
                                 "completion",
                                 "completion zsh",
                                 "check everything",
                                 "fuzz",
                                 "fuzz everything",
                                 "fuzz record 0",
                                 "test --all"}) {
    const auto result = launch(words_of(line));
    EXPECT_EQ(result.exit_code, 2) << line;
    EXPECT_EQ(result.output, "") << line;
    const bool explains = line.empty() ? result.errors.find("./moat") != std::string::npos
                                       : std::count(result.errors.begin(), result.errors.end(), '\n') >= 2;
    EXPECT_TRUE(explains) << line << ": " << result.errors;
  }
}

TEST_F(CommandLine, RefusesNumbersOfRanksThatNoMachineHas) {
  write_text(folder / "study.cpp", "int main() { return 7; }\n");
  for (const char* ranks : {"0", "-1", "4097", "99999999999", "1e3", "", "many"}) {
    const auto result = launch({"run", "--ranks", ranks, "study.cpp"});
    EXPECT_EQ(result.exit_code, 2) << ranks;
    EXPECT_NE(result.errors.find("--ranks"), std::string::npos) << result.errors;
    EXPECT_NE(result.errors.find("\nmoat: See ./moat run --help."), std::string::npos) << result.errors;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "cache")) << "nothing has started";
}

TEST_F(CommandLine, SaysThatANameIsTooLong) {
  const std::string name(300, 'a');
  EXPECT_NE(launch({"run", name + ".cpp"}).errors.find("There is no readable script aaa"), std::string::npos);
  EXPECT_NE(launch({"new", name}).errors.find("cannot be written: File name too long"), std::string::npos);
}

TEST_F(CommandLine, SuggestsACommandThatIsMeant) {
  EXPECT_EQ(launch({"rum"}).errors.substr(0, 48), "moat: There is no command rum. Did you mean run?");
}

TEST_F(CommandLine, SuggestsAnOptionThatIsMeant) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"new", "--projekt", "x"}, {"new", "x", "--projekt"}, {"new", "--projekt"}})
    EXPECT_EQ(launch(words).errors,
              "moat: new has no option --projekt. Did you mean --project?\nmoat: See ./moat new --help.\n");
  EXPECT_EQ(launch({"doctor", "--bogus"}).errors,
            "moat: doctor has no option --bogus.\nmoat: See ./moat doctor --help.\n");
}

TEST_F(CommandLine, NewScriptRunsUnderItsOwnNameAndTheSecondTimeInSilence) {
  ASSERT_EQ(launch({"new", "my tower.cpp"}).exit_code, 0);
  const auto first = launch({"run", "my tower.cpp", "--help"});
  EXPECT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_EQ(first.output.substr(0, first.output.find('\n')), "my tower");
  EXPECT_NE(first.output.find("--gap"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "cache" / "scripts"));
  const auto second = launch({"run", "my tower.cpp", "--gap", "50 cm", "--end", "0.1 s", "--out", "there"});
  EXPECT_EQ(second.exit_code, 0) << second.errors;
  EXPECT_EQ(second.errors.find("compile"), std::string::npos) << second.errors;
  // The results name the script that the launcher compiled.
  const std::string summary = moat::testing::text_of(folder / "there" / "summary.json");
  const std::string script = folder / "my tower.cpp";
  EXPECT_NE(summary.find("\"script\": \"" + script + "\""), std::string::npos) << summary;
  EXPECT_NE(summary.find(sha256_of(moat::testing::text_of(script))), std::string::npos);
}

TEST_F(CommandLine, PassesOnTheExitCodeOfTheScript) {
  write_text(folder / "seven.cpp", "int main() { return 7; }\n");
  EXPECT_EQ(launch({"run", "seven.cpp"}).exit_code, 7);
}

TEST_F(CommandLine, DoctorShowsPlacesAndVersions) {
  const auto result = launch({"doctor"});
  EXPECT_NE(result.output.find("\nlibrary "), std::string::npos) << result.output << result.errors;
  EXPECT_NE(result.output.find("\nlibeigen3-dev "), std::string::npos) << result.output;
}

}  // namespace
}  // namespace moat::launcher
