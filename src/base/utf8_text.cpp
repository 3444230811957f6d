#include "base/utf8_text.hpp"

#include <utf8.h>

#include <iterator>

namespace moat {

bool is_utf8(std::string_view text) { return utf8::is_valid(text.begin(), text.end()); }

std::string as_utf8(std::string_view text) {
  std::string valid;
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid));
  return valid;
}

}  // namespace moat
