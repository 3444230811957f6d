#include "output/files/xml_text.hpp"

#include "base/text/utf8_text.hpp"

namespace moat {

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
