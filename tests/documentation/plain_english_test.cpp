// Comments, messages and documents keep to the words of CONTRIBUTING.md, section English.

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

namespace moat {
namespace {

namespace fs = std::filesystem;

enum class Kind { cpp, markdown, script, other };

Kind kind_of(const fs::path& path) {
  const fs::path name = path.filename(), extension = path.extension();
  if (extension == ".hpp" || extension == ".cpp") return Kind::cpp;
  if (extension == ".md") return Kind::markdown;
  for (const char* one : {".cmake", ".txt", ".sh", ".py"})
    if (extension == one) return Kind::script;
  return name == "moat" ? Kind::script : Kind::other;
}

// The comment and the texts of a line of C++. A text of one word is a name.
std::string prose_of_cpp(const std::string& line) {
  static const std::regex part{R"re('(?:[^'\\]|\\.)'|"((?:[^"\\]|\\.)*)"|(//.*))re"};
  std::string prose;
  for (std::sregex_iterator at{line.begin(), line.end(), part}, end; at != end; ++at)
    if ((*at)[2].matched || (*at)[1].str().find(' ') != std::string::npos)
      prose += (*at)[1].str() + (*at)[2].str() + " ";
  return prose;
}

// Headings that are questions, and quotations, are allowed.
std::string prose_of_markdown(const std::string& line) {
  static const std::regex question{R"(#.*\?)"}, quotation{R"("[^"]*")"};
  return std::regex_match(line, question) ? "" : std::regex_replace(line, quotation, "");
}

std::string prose_of(Kind kind, const std::string& line) {
  if (kind == Kind::cpp) return prose_of_cpp(line);
  return kind == Kind::markdown ? prose_of_markdown(line) : line;
}

// Pronouns that begin a clause without a noun, old words, idioms, and files and numbers that "tell".
constexpr std::array forbidden{"what",    "whatever",       "lest", "whoever", "anew", "hence",
                               "at hand", "there and back", "tell", "tells",   "told", "telling"};

// A parameter of such a name stands in backticks, or before a colon or a parenthesis.
bool breaks_the_rule(Kind kind, const std::string& line) {
  static const std::regex code{"`[^`]*`"};
  static const std::regex banned = [] {
    std::string words;
    for (const std::string word : forbidden) words += (words.empty() ? "" : "|") + word;
    return std::regex{"\\b(" + words + ")\\b(?![:(])", std::regex::icase};
  }();
  return std::regex_search(std::regex_replace(prose_of(kind, line), code, ""), banned);
}

// The end of a text R"x(...)x" that goes on after the line; empty if none does.
std::string end_of_open_text(const std::string& line) {
  static const std::regex begin{R"re(R"(\w*)\()re"};
  std::smatch match;
  if (!std::regex_search(line, match, begin)) return "";
  const std::string end = ")" + match[1].str() + "\"";
  return line.find(end) == std::string::npos ? end : "";
}

std::string lines_that_break_it(const fs::path& root, const fs::path& path) {
  const Kind kind = kind_of(path);
  if (kind == Kind::other || path.filename() == "plain_english_test.cpp") return "";
  std::ifstream file{path};
  std::string found, end_of_text;
  int number = 0;
  bool generated = false;
  for (std::string line; std::getline(file, line);) {
    ++number;
    // Generators are checked instead of the parts that they write.
    if (kind == Kind::markdown && line.starts_with("<!--")) generated = line.find(": begin") != std::string::npos;
    const bool in_text = !end_of_text.empty();
    if (!generated && breaks_the_rule(in_text ? Kind::script : kind, line))
      found += path.lexically_relative(root).string() + ":" + std::to_string(number) + ": " + line + "\n";
    if (kind != Kind::cpp) continue;
    if (!in_text)
      end_of_text = end_of_open_text(line);
    else if (line.find(end_of_text) != std::string::npos)
      end_of_text.clear();
  }
  return found;
}

std::string lines_that_break_it() {
  const fs::path root = MOAT_SOURCE_DIR;
  std::string found;
  for (const auto& entry : fs::directory_iterator{root})
    if (entry.is_regular_file()) found += lines_that_break_it(root, entry.path());
  for (const char* folder :
       {"analyses", "benchmarks", "cmake", "docs", "elements", "examples", "materials", "src", "structures", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator{root / folder})
      if (entry.is_regular_file()) found += lines_that_break_it(root, entry.path());
  return found;
}

TEST(PlainEnglish, KnowsTheWordsThatItForbids) {
  for (const std::string word : forbidden) {
    for (const std::string& line :
         {"// " + word + " a Script holds.", "  int a = 1;  // removed, " + word,
          "std::puts(\"a list, " + word + "\");", "f(\"https://a.b\", '\"', \"say \\\"when\\\" and " + word + "\");"})
      EXPECT_TRUE(breaks_the_rule(Kind::cpp, line)) << line;
    EXPECT_TRUE(breaks_the_rule(Kind::markdown, "    ./moat run a.cpp     # " + word + " is missing"));
    EXPECT_TRUE(breaks_the_rule(Kind::markdown, "## Of figures, " + word));
    EXPECT_TRUE(breaks_the_rule(Kind::script, "# Installs " + word + " is missing."));
  }
  for (const char* line : {"error.what()", "/// Throws InputError naming `what`.", "/// what: how messages call it.",
                           "refuse(what, \"is too large.\");", "check(\"what\");", "// somewhat later"})
    EXPECT_FALSE(breaks_the_rule(Kind::cpp, line)) << line;
  EXPECT_FALSE(breaks_the_rule(Kind::markdown, "## What does a step cost?"));
  EXPECT_FALSE(breaks_the_rule(Kind::markdown, "| \"for whoever knows the motion\" | name the actor |"));
  EXPECT_EQ(end_of_open_text("const char* text = R\"js("), ")js\"");
  EXPECT_EQ(end_of_open_text("const char* text = R\"(a)\";"), "");
  EXPECT_EQ(kind_of("cmake/packages/run.txt"), Kind::script);
  EXPECT_EQ(kind_of("moat"), Kind::script);
}

TEST(PlainEnglish, IsThatOfCommentsMessagesAndDocuments) { EXPECT_EQ(lines_that_break_it(), ""); }

}  // namespace
}  // namespace moat
