#include "launcher/designated_list.hpp"

#include <algorithm>
#include <cctype>
#include <regex>

#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

constexpr std::size_t none = std::string::npos;
constexpr const char* blanks = " \t\n\r\v\f";

// The offset of the last quotation mark of R"x(...)x", whose first one is at `begin`.
std::size_t end_of_raw_text(const std::string& source, std::size_t begin) {
  const std::size_t bracket = std::min(source.find('(', begin), source.size());
  const std::string closing = ")" + source.substr(begin + 1, bracket - begin - 1) + "\"";
  const std::size_t close = source.find(closing, bracket);
  return close == none ? source.size() : close + closing.size() - 1;
}

// With blanks in the place of comments and of the insides of texts, so that their brackets do not count.
std::string code_of(const std::string& source) {
  std::string code = source;
  const auto blank = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < std::min(end, code.size()); ++i)
      if (code[i] != '\n') code[i] = ' ';
  };
  for (std::size_t i = 0; i < code.size(); ++i) {
    std::size_t end = i;
    if (code.compare(i, 2, "//") == 0) {
      end = std::min(source.find('\n', i), source.size());
      blank(i, end);
    } else if (code.compare(i, 2, "/*") == 0) {
      const std::size_t close = source.find("*/", i + 2);
      end = close == none ? source.size() : close + 2;
      blank(i, end);
    } else if (code[i] == '"' && i > 0 && code[i - 1] == 'R') {
      end = end_of_raw_text(source, i);
      blank(i + 1, end);
    } else if (code[i] == '"') {
      for (end = i + 1; end < source.size() && source[end] != '"' && source[end] != '\n'; ++end)
        if (source[end] == '\\') ++end;
      blank(i + 1, end);
    } else if (code[i] == '\'' && (i == 0 || std::isalnum(static_cast<unsigned char>(code[i - 1])) == 0)) {
      end = std::min(source.find('\'', i + (source.compare(i + 1, 1, "\\") == 0 ? 3 : 2)), source.size());
      blank(i + 1, end);
    }
    i = end;
  }
  return code;
}

bool opens(char c) { return c == '{' || c == '(' || c == '['; }
bool closes(char c) { return c == '}' || c == ')' || c == ']'; }

char counterpart(char opening) {
  if (opening == '{') return '}';
  return opening == '(' ? ')' : ']';
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == none ? "" : text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

// `brace` is the offset of the brace that opens the list.
DesignatedList list_at(const std::string& source, const std::string& code, std::size_t brace) {
  constexpr const char* letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
  static const std::regex type{R"(\b(?!return\b)(\w+)(<[^;{}]*>)?(\s+\w+)?(\s*=)?\s*$)"};
  DesignatedList list;
  const std::size_t statement = brace == 0 ? none : code.find_last_of(";{}(),", brace - 1);
  const std::size_t first = std::max(statement + 1, brace - std::min(brace, longest_line));  // none + 1 is 0
  const std::string front = code.substr(first, brace - first);
  std::smatch match;
  if (std::regex_search(front, match, type)) list.type = match[1];
  int depth = 0;
  std::size_t begin = brace + 1;
  for (std::size_t i = begin; i < code.size(); ++i) {
    if (opens(code[i])) ++depth;
    const bool ends = closes(code[i]) && depth == 0;
    if (ends || (code[i] == ',' && depth == 0)) {
      const std::size_t point = code.find_first_not_of(blanks, begin);
      if (code[point] == '.') {
        const std::size_t behind = code.find_first_not_of(letters, point + 1);
        const std::size_t equal = code.find_first_not_of(blanks, behind);
        if (behind > point + 1 && code[equal] == '=')
          list.fields.push_back({.name = code.substr(point + 1, behind - point - 1),
                                 .value = trimmed(source.substr(equal + 1, i - equal - 1)),
                                 .offset = point});
      }
      begin = i + 1;
    }
    if (ends) break;
    if (closes(code[i])) --depth;
  }
  return list;
}

}  // namespace

std::size_t offset_of(const std::string& source, int line, int column) {
  constexpr int tabulator = 8;
  std::size_t offset = column < 1 ? source.size() : 0;
  for (int i = 1; i < line; ++i) {
    offset = source.find('\n', offset);
    if (offset == none) return source.size();
    ++offset;
  }
  const auto continues_letter = [](unsigned char c) { return (c & 0xC0U) == 0x80U; };
  for (int at = 1; offset < source.size() && source[offset] != '\n'; ++offset) {
    if (continues_letter(static_cast<unsigned char>(source[offset]))) continue;
    if (at >= column) return offset;
    at += source[offset] == '\t' ? tabulator - (at - 1) % tabulator : 1;
  }
  return source.size();
}

int line_at(const std::string& source, std::size_t offset) {
  const auto end = source.begin() + static_cast<std::ptrdiff_t>(std::min(offset, source.size()));
  return static_cast<int>(1 + std::count(source.begin(), end, '\n'));
}

std::vector<std::string> items_of(const std::string& list) {
  const std::string code = code_of(list);
  if (code.empty() || code.front() != '{') return {};
  std::vector<std::string> items;
  int depth = 0;
  std::size_t begin = 1;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (opens(code[i])) ++depth;
    if (closes(code[i])) --depth;
    if (depth == 0 && i + 1 < code.size()) return {};
    if (depth != 0 && !(depth == 1 && code[i] == ',')) continue;
    if (std::string item = trimmed(list.substr(begin, i - begin)); !item.empty()) items.push_back(std::move(item));
    begin = i + 1;
  }
  return items;
}

std::optional<WrongBracket> first_wrong_bracket(const std::string& source) {
  const std::string code = code_of(source);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (opens(code[i])) open.push_back(i);
    if (!closes(code[i])) continue;
    if (open.empty()) return WrongBracket{.opening = {}, .closing = i};
    if (counterpart(code[open.back()]) != code[i]) return WrongBracket{.opening = open.back(), .closing = i};
    open.pop_back();
  }
  return {};
}

DesignatedList list_around(const std::string& source, std::size_t offset) {
  const std::string code = code_of(source);
  int depth = 0;
  for (std::size_t i = std::min(offset, code.size()); i > 0; --i) {
    const char c = code[i - 1];
    if (closes(c)) ++depth;
    if (opens(c) && --depth < 0) return c == '{' ? list_at(source, code, i - 1) : DesignatedList{};
  }
  return {};
}

DesignatedList list_in_call(const std::string& source, std::size_t offset) {
  const std::string code = code_of(source);
  if (offset >= code.size() || code[offset] != '(') return {};
  DesignatedList list;
  int depth = 0;
  for (std::size_t i = offset; i < code.size(); ++i) {
    if (opens(code[i])) ++depth;
    if (closes(code[i]) && --depth == 0) break;
    if (code[i] != '{' || depth != 2) continue;
    const std::size_t first = code.find_first_not_of(" \t\n", i + 1);
    if (first == none || code[first] != '.') continue;
    if (!list.fields.empty()) return {};
    list = list_at(source, code, i);
  }
  return list;
}

}  // namespace moat::launcher
