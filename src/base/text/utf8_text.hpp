// Text in UTF-8, the encoding of all files that moat writes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace moat {

/// Whether every sequence of bytes is a character of UTF-8.
bool is_utf8(std::string_view text);

/// With a replacement character for every sequence of bytes that is not UTF-8.
std::string as_utf8(std::string_view text);

/// The number of characters of a text in UTF-8, which is its width on a terminal for most languages.
std::size_t characters_in(std::string_view text);

/// Lines of cells as text in columns, two blanks before each. All lines have as many cells; empty ones are left out.
std::string in_columns(const std::vector<std::vector<std::string>>& lines);

/// In UTF-8, with "?" for characters that turn the direction of text and for U+FFFE and U+FFFF.
std::string as_plain_text(std::string_view text);

/// Text for an element or an attribute between double quotes, with entities for &, <, > and the double quote, in UTF-8.
/// Characters that XML does not have, and those that turn the direction of text, become "?".
std::string escaped_for_xml(std::string_view text);

}  // namespace moat
