#include "base/parse_quantity.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/error.hpp"
#include "base/known_units.hpp"

namespace moat {
namespace {

// SI, of any dimension: far beyond every building, and near enough that numbers computed from it stay finite.
constexpr double largest_quantity = 1e15;

constexpr auto symbols = common_units_and(std::array{known_unit("min", units::minute), known_unit("t", units::tonne)});

struct Unit {
  double si = 1.0;
  int mass = 0, half_length = 0, time = 0;
};

[[noreturn]] void refuse(std::string_view what, std::string_view text, const std::string& problem) {
  std::string message{what};
  message.append(": \"").append(text).append("\" ").append(problem);
  throw InputError{message};
}

// A power in halves: 2 -> 4, 1.5 -> 3. Nothing for anything finer.
std::optional<int> power_in_halves(std::string_view text) {
  double power = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), power);
  if (error != std::errc{} || end != text.data() + text.size() || std::abs(power) > 8.0) return std::nullopt;
  const double halves = 2.0 * power;
  if (halves != std::round(halves)) return std::nullopt;
  return static_cast<int>(halves);
}

// " Did you mean cm?" for CM; empty where no symbol has these letters.
std::string meant_by(std::string_view name) {
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  for (const KnownUnit& known : symbols)
    if (std::ranges::equal(known.name, name, same)) return " Did you mean " + std::string{known.name} + "?";
  return "";
}

void multiply(Unit& unit, std::string_view factor, int sign, std::string_view what, std::string_view text) {
  const std::size_t caret = factor.find('^');
  const std::string_view name = factor.substr(0, caret);
  std::optional<int> halves = 2;
  if (caret != std::string_view::npos) halves = power_in_halves(factor.substr(caret + 1));
  for (const KnownUnit& known : symbols) {
    if (known.name != name) continue;
    const auto raised = [&](int exponent) -> int {
      if (halves && exponent * *halves % 2 == 0) return sign * exponent * *halves / 2;
      refuse(what, text, "has a power that is not a whole or half number: \"" + std::string{factor} + "\".");
    };
    if (!halves) raised(1);
    unit.mass += raised(known.mass);
    unit.half_length += raised(known.half_length);
    unit.time += raised(known.time);
    unit.si *= std::pow(known.si, 0.5 * sign * *halves);
    return;
  }
  refuse(what, text,
         "has an unknown unit \"" + std::string{name} + "\"." + meant_by(name) +
             " Known are m mm cm km s ms min kg t tonne N kN " +
             "MN GN J kJ MJ Hz and g (gravity), joined by / or a blank, with powers as in N/m^1.5.");
}

Unit parse_unit(std::string_view unit_text, std::string_view what, std::string_view text) {
  Unit unit;
  int sign = 1;
  bool joined = false;  // a / or * waits for the unit behind it
  const auto refuse_sign = [&] { refuse(what, text, "has a / or * that joins nothing in its unit."); };
  std::size_t at = unit_text.find_first_not_of(" \t");
  // "5 1/s" as messages write it.
  if (at != std::string_view::npos && unit_text.substr(at).starts_with("1/")) ++at;
  while (at < unit_text.size()) {
    const char c = unit_text[at];
    if (c == '/' || c == '*') {
      if (joined) refuse_sign();
      joined = true;
      if (c == '/') sign = -1;
      ++at;
    } else if (c == ' ' || c == '\t') {
      ++at;
    } else {
      const std::size_t end = std::min(unit_text.find_first_of("/* \t", at), unit_text.size());
      multiply(unit, unit_text.substr(at, end - at), sign, what, text);
      joined = false;
      at = end;
    }
  }
  if (joined) refuse_sign();
  return unit;
}

// The number with units that it may have: "0.4 g" or "0.4 m/s^2".
std::string with_unit(std::string_view number, int mass, int half_length, int time) {
  const std::string wanted = unit_symbol(mass, half_length, time), begin = '"' + std::string{number} + ' ';
  std::string first;
  for (const char* usual : {"cm", "g", "kN", "tonne", "MN/m", "kN/m", "cm/s"})
    if (const Unit unit = parse_unit(usual, "", "");
        first.empty() && unit.mass == mass && unit.half_length == half_length && unit.time == time)
      first = begin + usual + "\" or ";
  return first + begin + wanted + '"';
}

[[noreturn]] void refuse_unit_of_plain_number(std::string_view what, std::string_view text, double number,
                                              std::string_view unit_text) {
  if (unit_text.substr(unit_text.find_first_not_of(" \t")) != "%")
    refuse(what, text, "has a unit, but it must be a plain number.");
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number / 100.0).ptr;
  refuse(what, text, "is in percent. Write it as a plain number: " + std::string{digits.data(), end} + ".");
}

}  // namespace

double parse_si(std::string_view text, std::string_view what, int mass, int half_length, int time) {
  const std::string wanted = unit_symbol(mass, half_length, time);
  std::size_t start = text.find_first_not_of(" \t");
  if (start == std::string_view::npos) start = text.size();
  if (start + 1 < text.size() && text[start] == '+' && text[start + 1] != '-') ++start;
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data() + start, text.data() + text.size(), number);
  if (error == std::errc::result_out_of_range) {
    const bool large = std::abs(std::strtod(std::string{text.data() + start, end}.c_str(), nullptr)) > 1.0;
    refuse(what, text, large ? "is too large. Check its exponent." : "is too small; zero is 0.");
  }
  if (error != std::errc{} || !std::isfinite(number))
    refuse(what, text,
           wanted == "1"
               ? "is not a number. Write a plain number, 0.5 for example."
               : "does not start with a number. Write a number with its unit, in " + wanted + " for example.");
  const std::string_view unit_text = text.substr(static_cast<std::size_t>(end - text.data()));
  if (unit_text.size() > 1 && unit_text[0] == ',' && unit_text[1] >= '0' && unit_text[1] <= '9')
    refuse(what, text, "has a decimal comma. Write decimals with a point: 1.5.");
  const bool has_unit = unit_text.find_first_not_of(" \t") != std::string_view::npos;
  if (!has_unit && wanted != "1")
    refuse(what, text,
           "has no unit. Write " +
               with_unit(text.substr(start, static_cast<std::size_t>(end - text.data()) - start), mass, half_length,
                         time) +
               ".");
  if (wanted == "1" && has_unit) refuse_unit_of_plain_number(what, text, number, unit_text);
  if (has_unit && unit_text.substr(unit_text.find_first_not_of(" \t")) == "%")
    refuse(what, text, "is in percent, but it must be in " + wanted + " or multiples of it.");
  const Unit unit = parse_unit(unit_text, what, text);
  if (unit.mass != mass || unit.half_length != half_length || unit.time != time)
    refuse(what, text,
           "is in " + unit_symbol(unit.mass, unit.half_length, unit.time) + ", but it must be " + "in " + wanted +
               " or multiples of it.");
  const double value = number * unit.si;
  if (!std::isfinite(value)) refuse(what, text, "is too large. Check its exponent.");
  if (wanted != "1" && std::abs(value) > largest_quantity)
    refuse(what, text, "is too large: at most 1e+15 " + wanted + ". Check its unit.");
  return value;
}

}  // namespace moat
