#include "output/xml_text.hpp"

#include "output/report_html.hpp"

namespace moat {

std::string escaped_for_xml(std::string_view text) {
  std::string clean{text};
  for (char& c : clean)
    if (static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r') c = '?';
  return html::escaped(clean);
}

}  // namespace moat
