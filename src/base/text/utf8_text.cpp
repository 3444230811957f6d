#include "base/text/utf8_text.hpp"

#include <utf8.h>

#include <algorithm>
#include <iterator>

namespace moat {

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

std::string escaped_for_xml(std::string_view text) {
  std::string escaped;
  for (const char c : as_utf8(text)) {
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
