// Every option and argument of scripts and commands with texts that try to be more than text.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "hostile_files.hpp"
#include "run_program.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing::ProgramResult;
using testing::replaced;
using Words = std::vector<std::string>;

class HostileArguments : public testing::Hostile {
 protected:
  HostileArguments() {
    std::ofstream{here / "plain.txt"} << "0\n1\n0\n";
    std::ofstream{here / "a.AT2"} << "PEER\nA\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= .1 SEC\n0 .1 0\n";
  }

  [[nodiscard]] fs::path made() {
    const fs::path path = folder / "here";
    fs::create_directory(path);
    return path;
  }

  /// Runs it with a text in the place of every @. Files may appear below here/out alone, and stay harmless.
  ProgramResult run(const std::string& program, Words words, const std::string& text) {
    for (std::string& word : words)
      if (word.find('@') != std::string::npos) word = replaced(word, "@", text.c_str());  // up to a NUL
    fs::create_directories(here / deep);
    const std::set<fs::path> before = files();
    const ProgramResult result = testing::run_program(program, words, here);
    EXPECT_TRUE(result.exit_code >= 0 && result.exit_code <= 3) << result.exit_code;
    for (const std::string& shown : {result.output, result.errors}) EXPECT_EQ(printable(shown), shown);
    const bool is_json = result.exit_code == 0 && std::ranges::find(words, "--json") != words.end();
    EXPECT_TRUE(!is_json || nlohmann::json::accept(result.output)) << result.output;
    EXPECT_EQ(files(), before);
    for (const auto& entry : fs::recursive_directory_iterator{here / "out"}) {
      // As a part of a path it is a folder of that name.
      EXPECT_TRUE(entry.path().filename() != "pwned" || text.find("/pwned") != text.npos) << entry.path();
      if (entry.is_regular_file()) expect_harmless_file(entry.path(), text);
    }
    fs::remove_all(here / "out");
    return result;
  }

  /// Runs it with every option that its help lists and that no program had before, and with one of those that take a
  /// quantity, a plain number or nothing.
  void run_with_options(const std::string& program, const Words& base) {
    const std::string listed = testing::run_program(program, {"--help"}, here).output;
    static const std::regex option{R"(\n +(?:-\w,)?(--[\w-]+)(?: (\[|NUMBER| ))?)"};
    for (std::sregex_iterator each{listed.begin(), listed.end(), option}, end; each != end; ++each) {
      const std::string name = (*each)[1], kind = (*each)[2];
      if (!options.insert(name).second || (!kind.empty() && !options.insert(kind).second)) continue;
      SCOPED_TRACE(name);
      Words words;
      for (const std::string& word : base)
        if (!word.starts_with(name + "=")) words.push_back(word);
      words.push_back(name + "=" + (name == "--out" ? deep : "") + "@");
      for (const std::string& text : testing::hostile_strings()) run(program, words, text);
    }
  }

  [[nodiscard]] std::set<fs::path> files() const {
    std::set<fs::path> all;
    for (fs::recursive_directory_iterator entry{folder}, end; entry != end; ++entry)
      if (entry->path() == here / "out")
        entry.disable_recursion_pending();
      else
        all.insert(entry->path());
    all.insert({here / "out", here / "standard_output", here / "standard_error"});
    return all;
  }

  const std::string deep = "out/b/c/d/e/";  // below here for any number of ../ in a text
  const fs::path here = made();
  std::set<std::string> options{"--help"};
};

TEST_F(HostileArguments, OfScriptsStayTexts) {
  const std::string out = "--out=" + deep + "results", no_frames = "--frame-interval=0 s";
  run_with_options(OPTION_SCRIPT,
                   {out, no_frames, "--json", "--record=plain.txt", "--record-unit=g", "--record-step=0.01 s"});
  run_with_options(PLAN_SCRIPT, {out, no_frames, "--json", "--record=a.AT2"});
  options.erase("--out");  // that of a study is another one
  run_with_options(STUDY_SCRIPT, {out, "--json", "--gaps=2"});
  for (const char* name :
       {"--text", "--record", "--record-up", "--record-unit", "--record-step", "--record-columns", "--out",
        "--integrator", "--record-2", "--records-table", "--inside", "--threads", "--case", "--cases"})
    EXPECT_TRUE(options.contains(name)) << name;
}

// Its results bear the name of the script, also that of one whose name has dots alone.
TEST_F(HostileArguments, NamesOfScriptsStayNames) {
  std::vector<std::string> names{"...cpp", "..cpp", "-x.cpp"};
  for (const std::string& text : testing::hostile_strings()) names.push_back(testing::file_name(text) + ".cpp");
  for (const std::string& name : names) {
    SCOPED_TRACE(printable(name));
    const fs::path folder_of_script = here / deep / "script";
    fs::create_directories(folder_of_script);
    fs::create_symlink(OPTION_SCRIPT, folder_of_script / name);
    const auto result = testing::run_program(folder_of_script / name, {"--frame-interval=0 s"}, here / deep);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    const fs::path results = here / deep / "results";
    EXPECT_EQ(std::distance(fs::directory_iterator{results}, {}), 1);
    for (const auto& entry : fs::recursive_directory_iterator{results})
      if (entry.is_regular_file()) expect_harmless_file(entry.path(), name);
    fs::remove_all(here / "out");
  }
}

TEST_F(HostileArguments, OfCommandsStayTexts) {
  ASSERT_EQ(testing::run_program(STUDY_SCRIPT, {"--gaps=2", "--out=study"}, here).exit_code, 0);
  const Words places{MOAT_SOURCE_DIR, BUILD_FOLDER, folder / "cache"};
  const std::vector<Words> lines{{"@"},
                                 {"run", "@"},
                                 {"run", "--ranks=@", "a.cpp"},
                                 {"new", deep + "@", "--project"},
                                 {"motion", "@"},
                                 {"report", "@"},
                                 {"study", "@"},
                                 {"study", "show", "@"},
                                 {"study", "export", "@"},
                                 {"study", "export", "study", "--out=" + deep + "@.csv"},
                                 {"study", "merge", deep + "@.db", "study/study.db"},
                                 {"study", "merge", "out/all.db", "@"},
                                 {"bench", "@"},
                                 {"check", "@"},
                                 {"fuzz", "@"},
                                 {"fuzz", "record", "@"},
                                 {"completion", "@"}};
  for (const Words& line : lines) {
    SCOPED_TRACE(line.front() + " " + line.back());
    Words words = places;
    words.insert(words.end(), line.begin(), line.end());
    for (const std::string& text : testing::hostile_strings()) run(LAUNCHER, words, text);
  }
  run_with_options(MOTION_COMMAND, {"plain.txt", "--unit=g", "--step=0.01 s", "--out=" + deep + "spectrum"});
  run_with_options(REPORT_COMMAND, {"study"});
  EXPECT_TRUE(options.contains("--columns") && options.contains("--json"));
}

// A script that `moat new` writes can be run under any name. The checkout has a starter of its own.
TEST_F(HostileArguments, NamesOfNewScriptsStayNames) {
  const fs::path checkout = folder / "checkout", build = checkout / "build" / "release";
  for (const fs::path& path : {checkout / "src", checkout / "examples", build}) fs::create_directories(path);
  std::ofstream{checkout / "CMakeLists.txt"};
  std::ofstream{checkout / "examples/starter.cpp"}
      << "const char* name = \"starter\";\nint main() { return *name == 0; }\n";
  std::ofstream{build / "script_compile.txt"} << COMPILER << "\n";
  std::ofstream{build / "script_link.txt"};
  const Words places{checkout, build, folder / "here/out/cache"};
  int written = 0;
  for (const std::string& text : testing::hostile_strings()) {
    SCOPED_TRACE(printable(text.substr(0, 60)));
    fs::create_directories(here / deep);
    const std::string name = deep + text.c_str() + ".cpp";  // a program sees no more than this
    const auto launch = [&](const std::string& command, const std::string& file) {
      Words words = places;
      words.insert(words.end(), {command, file});
      const ProgramResult result = testing::run_program(LAUNCHER, words, here);
      for (const std::string& shown : {result.output, result.errors}) EXPECT_EQ(printable(shown), shown);
      return result;
    };
    if (launch("new", name).exit_code != 0) continue;
    ++written;
    const ProgramResult result = launch("run", name);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    fs::remove_all(here / "out");
  }
  EXPECT_GT(written, 15);
}

}  // namespace
}  // namespace moat
