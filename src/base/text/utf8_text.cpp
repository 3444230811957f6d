#include "base/text/utf8_text.hpp"

#include <utf8.h>

#include <algorithm>
#include <iterator>

namespace moat {
namespace {

// The overrides, embeddings and isolates of Unicode.
bool turns_text(char32_t character) {
  return (character >= 0x202A && character <= 0x202E) || (character >= 0x2066 && character <= 0x2069);
}

}  // namespace

bool is_utf8(std::string_view text) {
  // Nearly all texts are plain ASCII, which is seen without decoding.
  unsigned all = 0;
  for (const char byte : text) all |= static_cast<unsigned char>(byte);
  constexpr unsigned beyond_ascii = 0x80;
  return all < beyond_ascii || utf8::is_valid(text.begin(), text.end());
}

std::string as_utf8(std::string_view text) {
  std::string valid;
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid));
  return valid;
}

std::size_t characters_in(std::string_view text) {
  // Every character has one byte that continues no other.
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string in_columns(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.empty() ? 0 : lines.front().size());
  for (const std::vector<std::string>& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], characters_in(line[i]));
  std::string text;
  for (const std::vector<std::string>& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i)
      row += "  " + line[i] + std::string(widths[i] - characters_in(line[i]), ' ');
    row.erase(row.find_last_not_of(' ') + 1);
    if (!row.empty()) text += row + "\n";
  }
  return text;
}

std::string as_plain_text(std::string_view text) {
  const std::string valid = as_utf8(text);
  std::string plain;
  for (auto at = valid.begin(); at != valid.end();) {
    const auto begin = at;
    const char32_t character = utf8::unchecked::next(at);
    if (turns_text(character) || character == 0xFFFE || character == 0xFFFF)
      plain += '?';
    else
      plain.append(begin, at);
  }
  return plain;
}

std::string escaped_for_xml(std::string_view text) {
  std::string escaped;
  for (const char c : as_plain_text(text)) {
    const bool unknown = static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r';
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += unknown ? '?' : c;
  }
  return escaped;
}

}  // namespace moat
