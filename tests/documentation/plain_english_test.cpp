// Comments, messages and documents keep to the words and the sentences of CONTRIBUTING.md, section English.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

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

// A character, a text and a comment.
const std::regex part_of_cpp{R"re('(?:[^'\\]|\\.)'|"((?:[^"\\]|\\.)*)"|(//.*))re"};

// The comment and the texts of a line of C++. A text of one word is a name.
std::string prose_of_cpp(const std::string& line) {
  std::string prose;
  for (std::sregex_iterator at{line.begin(), line.end(), part_of_cpp}, end; at != end; ++at)
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

// A paragraph of a comment or of a document, without code, tables and pictures.
struct Passage {
  int line = 0;
  bool begins = false;  // whether a comment begins with it
  std::string text;
};

std::string comment_of(const std::string& line) {
  for (std::sregex_iterator at{line.begin(), line.end(), part_of_cpp}, end; at != end; ++at)
    if ((*at)[2].matched) return (*at)[2];
  return "";
}

class Passages {
 public:
  Passages(Kind kind, std::istream& file) {
    for (std::string line; std::getline(file, line);) {
      ++number_;
      kind == Kind::cpp ? take_cpp(line) : take_markdown(line);
    }
  }
  [[nodiscard]] const std::vector<Passage>& list() const { return list_; }

 private:
  // The second line of a comment behind code has a `<` as well.
  void take_cpp(const std::string& line) {
    const std::string comment = comment_of(line);
    const bool alone = line.find_first_not_of(' ') == line.size() - comment.size();
    const bool goes_on = in_comment_ && alone && (!behind_code_ || comment.starts_with("///<"));
    if (!goes_on) paragraph_ = false;
    behind_code_ = goes_on ? behind_code_ : !alone;
    in_comment_ = !comment.empty();
    const std::size_t text = comment.find_first_not_of("/<!");
    take(text == std::string::npos ? "" : comment.substr(text + 1), !goes_on);
  }
  void take_markdown(const std::string& line) {
    if (line.starts_with("<!--")) generated_ = line.find(": begin") != std::string::npos;
    const bool fence = line.find("```") != std::string::npos;
    if (fence) fenced_ = !fenced_;
    const bool left_out = fence || fenced_ || generated_ || line.starts_with("#") || line.starts_with("<!--");
    take(left_out ? "" : line, false);
  }
  void take(const std::string& text, bool begins) {
    static const std::regex item{R"( *([-*]|[0-9]+\.) .*)"}, none{R"( *|    .*|\|.*)"};
    const bool prose = !std::regex_match(text, none);
    if (prose && (!paragraph_ || std::regex_match(text, item))) list_.push_back({number_, begins, ""});
    paragraph_ = prose;
    if (prose) list_.back().text += text + " ";
  }

  std::vector<Passage> list_;
  int number_ = 0;
  bool paragraph_ = false, in_comment_ = false, behind_code_ = false, generated_ = false, fenced_ = false;
};

using Rule = bool (*)(Kind, const Passage&);

// Such a beginning has no subject, and mostly no verb.
bool begins_without_subject(Kind, const Passage& passage) {
  static const std::regex beginning{
      R"((Of|Those|That of|The same|As above|Below|All of it|Its|Their|From memory)\b.*)"};
  return passage.begins && std::regex_match(passage.text, beginning);
}

struct Sentence {
  int words = 0, of_pronoun = 0;  // of_pronoun: how often it says "that of" or "those of"
};

std::vector<Sentence> sentences_of(const std::string& text) {
  static const std::regex code{"`[^`]*`"};
  std::istringstream words{std::regex_replace(text, code, "x")};
  std::vector<Sentence> list(1);
  std::string before;
  for (std::string word; words >> word; before = word) {
    if (std::ranges::any_of(word, [](unsigned char one) { return std::isalpha(one) != 0; })) ++list.back().words;
    if (word == "of" && (before == "that" || before == "those" || before == "That" || before == "Those"))
      ++list.back().of_pronoun;
    const std::size_t last = word.find_last_not_of(")\"'*_");
    if (last != std::string::npos && std::string{".!?"}.find(word[last]) != std::string::npos) list.emplace_back();
  }
  return list;
}

bool is_long(Kind kind, const Passage& passage) {
  const int most = kind == Kind::cpp ? 40 : 35;
  return std::ranges::any_of(sentences_of(passage.text), [&](const Sentence& each) { return each.words > most; });
}

bool is_chain(Kind, const Passage& passage) {
  return std::ranges::any_of(sentences_of(passage.text), [](const Sentence& each) { return each.of_pronoun > 1; });
}

// Comments of the library and its examples, and all documents.
std::string passages_that(Rule rule) {
  const fs::path root = MOAT_SOURCE_DIR;
  std::string found;
  const auto look = [&](const fs::path& path) {
    const Kind kind = kind_of(path);
    if (kind != Kind::cpp && kind != Kind::markdown) return;
    std::ifstream file{path};
    const Passages passages{kind, file};
    for (const Passage& each : passages.list())
      if (rule(kind, each))
        found += path.lexically_relative(root).string() + ":" + std::to_string(each.line) + ": " + each.text + "\n";
  };
  for (const auto& entry : fs::directory_iterator{root}) look(entry.path());
  for (const char* folder : {"analyses", "docs", "elements", "examples", "materials", "src", "structures"})
    for (const auto& entry : fs::recursive_directory_iterator{root / folder}) look(entry.path());
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

std::vector<Passage> passages_in(Kind kind, const std::string& text) {
  std::istringstream file{text};
  return Passages{kind, file}.list();
}

TEST(PlainEnglish, FindsThePassagesOfCommentsAndDocuments) {
  const auto comments =
      passages_in(Kind::cpp,
                  "/// Returns a force,\n/// N.\n///\n///     picture\n///\n/// Its sign is +.\n"
                  "double f(\"// no\");  ///< Of both\n           ///< ends.\nint a;  // m\n// Why.\n");
  ASSERT_EQ(comments.size(), 5u);
  EXPECT_EQ(comments[0].text, "Returns a force, N. ");
  EXPECT_FALSE(begins_without_subject(Kind::cpp, comments[1]));
  EXPECT_EQ(comments[2].text, "Of both ends. ");
  EXPECT_EQ(comments[2].line, 7);
  EXPECT_TRUE(begins_without_subject(Kind::cpp, comments[2]));
  EXPECT_EQ(comments[4].text, "Why. ");
  EXPECT_TRUE(comments[4].begins);

  const auto document = passages_in(Kind::markdown,
                                    "# Title\nOne\ntwo.\n\n- item\n  goes on\n- item\n| a | b |\n```\ncode\n```\n"
                                    "<!-- table: begin -->\nwritten\n<!-- table: end -->\nLast.\n");
  ASSERT_EQ(document.size(), 4u);
  EXPECT_EQ(document[0].text, "One two. ");
  EXPECT_EQ(document[1].text, "- item   goes on ");
  EXPECT_EQ(document[3].line, 15);
}

TEST(PlainEnglish, KnowsLongSentencesAndChains) {
  std::string words;
  for (int i = 0; i < 36; ++i) words += "word ";
  EXPECT_TRUE(is_long(Kind::markdown, {1, true, words}));
  EXPECT_FALSE(is_long(Kind::cpp, {1, true, words}));
  EXPECT_TRUE(is_long(Kind::cpp, {1, true, words + words}));
  EXPECT_FALSE(is_long(Kind::cpp, {1, true, words + "(end.) `a b c d e f` 1 2 3 " + words}));
  EXPECT_TRUE(is_chain(Kind::cpp, {1, true, "The rate is that of the law, and those of others."}));
  EXPECT_FALSE(is_chain(Kind::cpp, {1, true, "The rate is that of the law. That of others is not."}));
}

TEST(PlainEnglish, IsThatOfCommentsMessagesAndDocuments) { EXPECT_EQ(lines_that_break_it(), ""); }

TEST(PlainEnglish, GivesCommentsASubject) { EXPECT_EQ(passages_that(begins_without_subject), ""); }

// A document's sentence has at most 35 words, a comment's 40.
TEST(PlainEnglish, KeepsSentencesShort) { EXPECT_EQ(passages_that(is_long), ""); }

TEST(PlainEnglish, NamesWhatPronounsStandFor) { EXPECT_EQ(passages_that(is_chain), ""); }

}  // namespace
}  // namespace moat
