#include "motions/readers/number_text.hpp"

#include <charconv>
#include <string>
#include <system_error>

namespace moat {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_sign(char c) { return c == '+' || c == '-'; }

std::size_t skip_digits(std::string_view text, std::size_t position) {
  while (position < text.size() && is_digit(text[position])) ++position;
  return position;
}

ScannedNumber refused(const char* problem) {
  ScannedNumber result;
  result.problem = problem;
  return result;
}

}  // namespace

ScannedNumber scan_number(std::string_view text) {
  std::size_t position = !text.empty() && is_sign(text[0]) ? 1 : 0;
  const std::size_t mantissa = position;
  position = skip_digits(text, position);
  std::size_t digits = position - mantissa;
  if (position < text.size() && text[position] == '.') {
    const std::size_t decimals = ++position;
    position = skip_digits(text, decimals);
    digits += position - decimals;
  }
  if (digits == 0) return refused("is not a number");

  std::size_t exponent_mark = std::string_view::npos;
  if (position < text.size() && std::string_view{"EeDd"}.find(text[position]) != std::string_view::npos) {
    exponent_mark = position++;
    if (position < text.size() && is_sign(text[position])) ++position;
    const std::size_t exponent = position;
    position = skip_digits(text, exponent);
    if (position == exponent) return refused("has no digits in its exponent");
    if (position - exponent > 3) return refused("has more than three digits in its exponent");
  }

  // std::from_chars reads neither a leading plus nor the exponent D of Fortran's double precision.
  std::string plain{text.substr(mantissa, position - mantissa)};
  if (exponent_mark != std::string_view::npos) plain[exponent_mark - mantissa] = 'e';
  ScannedNumber result;
  const auto [end, failure] = std::from_chars(plain.data(), plain.data() + plain.size(), result.value);
  if (failure == std::errc::result_out_of_range) return refused("is too large or too small for a double");
  if (failure != std::errc{} || end != plain.data() + plain.size()) return refused("is not a number");
  if (text[0] == '-') result.value = -result.value;
  result.length = position;
  result.has_exponent = exponent_mark != std::string_view::npos;
  return result;
}

ScannedNumber parse_number(std::string_view text) {
  const ScannedNumber result = scan_number(text);
  if (!result.problem && result.length != text.size()) return refused("is not a number");
  return result;
}

}  // namespace moat
