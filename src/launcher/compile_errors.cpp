#include "launcher/compile_errors.hpp"

#include <algorithm>
#include <optional>
#include <regex>
#include <set>

#include "launcher/dimension_words.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

// The first error: "tower.cpp:5:13: error: ..."
struct Error {
  std::string file;
  int line = 0, column = 0;
  std::string text;   // with those of all notes behind it
  std::string shown;  // GCC's words, with the line of the source
};

std::optional<Error> first_error(const std::string& output) {
  static const std::regex head{R"((.+?):(\d{1,9}):(?:(\d{1,9}):)? (?:fatal )?(error|warning|note): .*)"};
  std::optional<Error> first;
  std::string before;
  bool is_shown = false;
  for (const std::string& line : lines_of(with_short_lines(output))) {
    std::smatch match;
    if (std::regex_match(line, match, head)) {
      const Error error{match[1], std::stoi(match[2]), match[3].matched ? std::stoi(match[3]) : 0, "", ""};
      is_shown = !first && match[4] == "error";
      if (is_shown) (first = error)->shown = before.find("required from") == std::string::npos ? "" : before;
      if (first && match[4] == "error" && (error.line != first->line || error.column != first->column)) break;
      if (first) first->text += replaced(replaced(line, "‘", "'"), "’", "'") + "\n";
      before.clear();
    } else if (line.find(" |") == std::string::npos) {  // no line of the source
      before += line + "\n";
      continue;
    }
    if (is_shown) first->shown += line + "\n";
  }
  return first;
}

// "this is a force [N], but a mass [kg] is needed", where GCC names the types of a conversion or of two sides.
std::string wrong_dimension(const Error& error) {
  static const std::regex types{R"((error: .*(?:from|convert)|note: .*\(type|operand types are) '([^'\n]*)')"
                                R"((?: \{aka '[^'\n]*'\})?\)? (?:to (?:non-scalar )?(?:type )?|and )'([^'\n]*)')"};
  std::smatch match;
  if (!std::regex_search(error.text, match, types)) return "";
  const std::string kind = match[1], left = dimension_of_type(match[2]), right = dimension_of_type(match[3]);
  const std::string text = misfit("this", left, right);
  if (kind.starts_with("note") && error.text.find("class template argument deduction failed") == std::string::npos)
    return "";
  return kind.starts_with("operand") && !text.empty() ? "left stands " + left + ", right " + right : text;
}

// The struct that GCC needs in the place of a list in braces; empty where there are several.
std::string type_of_argument(const Error& error) {
  static const std::regex needed{R"((?:<brace-enclosed initializer list>' to|declaration order in|reference of type) )"
                                 R"('(?:const )?moat::(\w+))"};
  std::set<std::string> types;
  for (std::sregex_iterator match{error.text.begin(), error.text.end(), needed}, end; match != end; ++match)
    types.insert((*match)[1]);
  return types.size() == 1 ? *types.begin() : "";
}

// The end of the line before GCC's place, where it ends without the semicolon that GCC misses there.
std::optional<std::size_t> missing_semicolon(const Error& error, const std::string& source, std::size_t offset) {
  static const std::regex expected{R"(error: expected (?:(?:',' or )?';'|(initializer) before))"};
  const std::string code = code_of(source);
  std::smatch match;
  if (code.empty() || offset == 0 || !std::regex_search(error.text, match, expected)) return {};
  constexpr const char* blanks = " \t\r\n";
  const std::size_t last = code.find_last_not_of(blanks, offset - 1), next = code.find_first_not_of(blanks, last + 1);
  if (last == std::string::npos || next == std::string::npos) return {};
  const bool ends_line = code.find('\n', last) < next || code[next] == '}';
  return ends_line && !(match[1].matched && code[last] == ')') ? std::optional{last} : std::nullopt;
}

// The semicolon behind GCC's place where a list in braces goes on: `.storeys = 4;`.
std::optional<std::size_t> semicolon_in_list(const std::string& source, std::size_t offset) {
  static const std::regex next_field{R"(;\s*\.\w+\s*=[^]*)"};
  const std::string code = code_of(source);
  const std::size_t end = code.find_first_of(";}", std::min(offset, code.size()));
  if (end == std::string::npos || code[end] == '}') return {};
  const std::size_t line = code.find('\n', code.find_first_not_of("; \t\r\n", end));
  return std::regex_match(code.substr(end, line - end), next_field) ? std::optional{end} : std::nullopt;
}

// A function without a `return` that is given in a call of a function that needs its result.
bool returns_nothing(const Error& error, const std::string& source, std::size_t offset) {
  static const std::regex call{R"(no matching function for call to '(?:\w+::)*)"
                               R"((?:(?:run_|eccentricity_)?study|(?:run_)?suite|run_bounds|hunt_and_fill|)"
                               R"(smallest_gap(?:_of)?)\([^\n]*<lambda\()"},
      word{R"(\breturn\b)"};
  const std::string code = code_of(source);
  if (!std::regex_search(error.text, call) || offset >= code.size()) return false;
  const std::size_t begin = code.find('{', code.find("](", offset));
  std::size_t end = begin;
  for (int depth = 0; end < code.size(); ++end)
    if (depth += (code[end] == '{') - (code[end] == '}'); depth == 0) break;
  return begin != std::string::npos && !std::regex_search(code.substr(begin, end - begin), word);
}

// "tower.cpp:26: Moat has no field clearence; did you mean clearance?"; empty where nothing is certain.
std::string sentence_on(const Error& error, const std::filesystem::path& root) {
  const std::string source = text_of(error.file);
  std::size_t offset = 0;
  for (int i = 1; i < error.line; ++i) offset = std::min(source.find('\n', offset), source.size() - 1) + 1;
  offset = std::min(source.size(), offset + static_cast<std::size_t>(std::max(error.column - 1, 0)));
  Mistake mistake{offset, wrong_dimension(error)};
  if (const auto end = missing_semicolon(error, source, offset))
    mistake = {*end, "a semicolon is missing at the end of this line"};
  else if (const auto inside = semicolon_in_list(source, offset))
    mistake = {*inside, "this semicolon stands inside a list in braces; take a comma"};
  else if (returns_nothing(error, source, offset))
    mistake = {offset, "the function that is given here returns nothing; end it with `return NAME;`"};
  else if (const auto known = mistake_in_fields(source, offset, type_of_argument(error), root))
    mistake = *known;
  if (mistake.sentence.empty()) return "";
  const auto line = source.empty() ? error.line : 1 + std::ranges::count(source.substr(0, mistake.offset), '\n');
  return error.file + ":" + std::to_string(line) + ": " + mistake.sentence + "\n";
}

}  // namespace

std::string explained(const std::string& output, const std::filesystem::path& root) {
  const std::optional<Error> error = first_error(output);
  if (!error) return with_short_lines(output);
  return with_short_lines(sentence_on(*error, root) + error->shown);
}

}  // namespace moat::launcher
