#include "output/files/xml_text.hpp"

#include "base/text/utf8_text.hpp"

namespace moat {

std::string escaped_markup(std::string_view text) {
  std::string html;
  for (const char c : as_utf8(text)) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string escaped_for_xml(std::string_view text) {
  std::string clean{text};
  for (char& c : clean)
    if (static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r') c = '?';
  return escaped_markup(clean);
}

}  // namespace moat
