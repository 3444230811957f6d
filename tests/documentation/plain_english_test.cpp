// Comments keep to the words of CONTRIBUTING.md, section English.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace moat {
namespace {

// Clauses that begin with "what", and idioms. A parameter of that name stands in backticks, or before a colon.
bool breaks_the_rule(const std::string& line) {
  static const std::regex code{"`[^`]*`"};
  static const std::regex banned{R"(//.*\b(what\b(?!:)|lest|whoever|at hand|there and back))", std::regex::icase};
  return std::regex_search(std::regex_replace(line, code, ""), banned);
}

std::vector<std::string> lines_that_break_it() {
  const std::filesystem::path root = MOAT_SOURCE_DIR;
  std::vector<std::string> found;
  for (const char* folder : {"src", "materials", "elements", "structures", "analyses", "examples"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator{root / folder}) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      std::ifstream file{entry.path()};
      int number = 0;
      for (std::string line; std::getline(file, line);) {
        ++number;
        if (breaks_the_rule(line))
          found.push_back(entry.path().lexically_relative(root).string() + ":" + std::to_string(number) + ": " + line);
      }
    }
  return found;
}

TEST(PlainEnglish, KnowsWhatItForbids) {
  for (const char* line :
       {"// What a Script holds.", "  int a = 1;  // removed, and what it had", "/// lest it be lost"})
    EXPECT_TRUE(breaks_the_rule(line)) << line;
  for (const char* line : {"error.what()", "/// Throws InputError naming `what`.", "/// what: how messages call it.",
                           "std::puts(\"what is missing\");", "// somewhat later"})
    EXPECT_FALSE(breaks_the_rule(line)) << line;
}

TEST(PlainEnglish, IsThatOfAllComments) { EXPECT_EQ(lines_that_break_it(), std::vector<std::string>{}); }

}  // namespace
}  // namespace moat
