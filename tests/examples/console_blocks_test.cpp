// Output that documents show is the output of the command above it.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace moat {
namespace {

// A block "console" of a document: a command on its first line, and lines of its output in their order. "..." stands
// for any text, alone on a line for any lines.
struct ConsoleBlock {
  std::string document, command;
  std::vector<std::string> lines;
};

std::vector<ConsoleBlock> console_blocks_of(const std::filesystem::path& document) {
  std::vector<ConsoleBlock> blocks;
  std::ifstream stream{document};
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line == "```console") {
      inside = true;
      blocks.push_back({document.string(), "", {}});
    } else if (line == "```") {
      inside = false;
    } else if (inside && line.starts_with("$ ")) {
      blocks.back().command = line.substr(2);
    } else if (inside && line != "...") {
      blocks.back().lines.push_back(line);
    }
  }
  return blocks;
}

std::vector<ConsoleBlock> all_console_blocks() {
  std::vector<ConsoleBlock> blocks;
  const std::filesystem::path source{MOAT_SOURCE_DIR};
  const auto add = [&](const std::filesystem::path& document) {
    for (ConsoleBlock& block : console_blocks_of(document)) blocks.push_back(std::move(block));
  };
  add(source / "README.md");
  add(source / "examples/README.md");
  for (const auto& entry : std::filesystem::recursive_directory_iterator{source / "docs"})
    if (entry.path().extension() == ".md") add(entry.path());
  return blocks;
}

// Blanks may differ, because columns are as wide as their contents.
std::string squeezed(const std::string& line) { return std::regex_replace(line, std::regex{" +"}, " "); }

std::regex pattern_of(const std::string& line) {
  const std::string escaped = std::regex_replace(squeezed(line), std::regex{R"([.^$|()\[\]{}*+?\\])"}, R"(\$&)");
  return std::regex{" *" + std::regex_replace(escaped, std::regex{R"((\\\.){3})"}, ".*") + " *"};
}

class ConsoleBlocks : public testing::InTemporaryFolder {
 protected:
  // A tour, or the script of the document behind the comment "<!-- script: NAME -->".
  std::string program_of(const ConsoleBlock& block, const std::string& script) {
    const std::filesystem::path tours = std::filesystem::path{FIRST_TOUR}.parent_path();
    if (script.starts_with("examples/")) return tours.parent_path() / script;
    const std::string program = folder / ("script_" + script);
    if (std::filesystem::exists(program)) return program;
    const testing::ProgramResult result = testing::run_program(
        "/bin/bash",
        {"-c",
         "awk -v folder=. -f \"$0\" \"$1\" && mapfile -t compile <\"$2/script_compile.txt\" && "
         "mapfile -t link <\"$2/script_link.txt\" && \"${compile[@]}\" \"$3.cpp\" -o \"$3\" \"${link[@]}\"",
         std::string{MOAT_SOURCE_DIR} + "/tests/documentation/code_blocks.awk", block.document, tours.parent_path(),
         program},
        folder);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return program;
  }
  // The output of a command, which runs once.
  const std::string& output_of(const ConsoleBlock& block) {
    const auto [known, is_new] = outputs_.try_emplace(block.command);
    std::smatch match;
    if (!is_new) return known->second;
    EXPECT_TRUE(std::regex_match(block.command, match, std::regex{R"(\./moat run ([\w/]+)\.cpp(.*))"}));
    if (match.empty()) return known->second;
    const testing::ProgramResult result =
        testing::run_program("/bin/bash", {"-c", "\"$0\"" + match[2].str(), program_of(block, match[1])}, folder);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return known->second = result.output;
  }

 private:
  std::map<std::string, std::string> outputs_;
};

TEST_F(ConsoleBlocks, OfTheDocumentsAreTheOutputOfTheirCommands) {
  const std::vector<ConsoleBlock> blocks = all_console_blocks();
  EXPECT_GE(blocks.size(), 10U);
  EXPECT_EQ(blocks.front().document, (std::filesystem::path{MOAT_SOURCE_DIR} / "README.md").string());
  for (const ConsoleBlock& block : blocks) {
    SCOPED_TRACE(block.document + ": " + block.command);
    const std::string& output = output_of(block);
    std::istringstream lines{output};
    std::string line;
    for (const std::string& expected : block.lines) {
      const std::regex pattern = pattern_of(expected);
      bool found = false;
      while (!found && std::getline(lines, line)) found = std::regex_match(squeezed(line), pattern);
      EXPECT_TRUE(found) << "There is no line\n" << expected << "\nor not behind the one before it, in\n" << output;
      if (!found) break;
    }
  }
}

}  // namespace
}  // namespace moat
