// Text in UTF-8, the encoding of all files that moat writes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace moat {

/// Whether every sequence of bytes is a character of UTF-8.
bool is_utf8(std::string_view text);

/// With a replacement character for every sequence of bytes that is not UTF-8.
std::string as_utf8(std::string_view text);

/// The number of characters of a text in UTF-8, which is its width on a terminal for most languages.
std::size_t characters_in(std::string_view text);

/// Text for an element or an attribute between double quotes, with entities for &, <, > and the double quote, in UTF-8.
/// Control characters that XML does not have become "?".
std::string escaped_for_xml(std::string_view text);

}  // namespace moat
