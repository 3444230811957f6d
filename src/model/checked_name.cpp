#include "model/checked_name.hpp"

#include "base/text/utf8_text.hpp"

namespace moat {

void check_name(const Check& check, std::string_view name) {
  check.that(is_utf8(name), "the name is not UTF-8.", "Save the script in UTF-8.");
  check.that(name.empty() || std::string_view{"=+-@"}.find(name.front()) == std::string_view::npos,
             "the name begins with = + - or @.",
             "Spreadsheets take that for a formula; let the name begin with a letter or a digit.");
}

}  // namespace moat
