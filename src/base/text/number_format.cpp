#include "base/text/number_format.hpp"

#include <array>
#include <charconv>

namespace moat {
namespace {

// std::snprintf would write the decimal comma of the program's locale.
template <class... Form>
std::string written(double value, Form... form) {
  std::array<char, 400> text;  // the largest double has 309 digits before the point
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, form...).ptr;
  return {text.data(), end};
}

}  // namespace

std::string to_fixed(double value, int decimals) { return written(value, std::chars_format::fixed, decimals); }

std::string to_significant(double value, int digits) { return written(value, std::chars_format::general, digits); }

std::string to_exact(double value) { return written(value); }

}  // namespace moat
