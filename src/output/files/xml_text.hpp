// Texts inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace moat {

/// Text for an element or an attribute between double quotes, with entities for &, <, > and the double quote, in UTF-8.
/// Control characters that XML does not have become "?".
std::string escaped_for_xml(std::string_view text);

}  // namespace moat
