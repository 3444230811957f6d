#include "output/files/engineering_unit.hpp"

#include <algorithm>
#include <cmath>

#include "base/text/number_format.hpp"
#include "base/units.hpp"

namespace moat {

EngineeringUnit engineering_unit(std::string_view si_symbol) {
  if (si_symbol == "m") return {"cm", 100.0};
  if (si_symbol == "m/s") return {"cm/s", 100.0};
  if (si_symbol == "N") return {"kN", 1e-3};
  if (si_symbol == "J") return {"kJ", 1e-3};
  if (si_symbol == "rad") return {"mrad", 1e3};
  if (si_symbol == "N m") return {"kN m", 1e-3};
  return {std::string{si_symbol}, 1.0};
}

EngineeringUnit second_unit(std::string_view si_symbol) {
  return si_symbol == "m/s^2" ? EngineeringUnit{"g", 1.0 / standard_gravity} : EngineeringUnit{"", 1.0};
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string with_raised_digits(std::string_view unit) {
  std::string text{unit};
  for (std::size_t at = text.find("^2"); at != std::string::npos; at = text.find("^2")) text.replace(at, 2, "²");
  return text;
}

std::string in_words(std::string_view quantity) {
  std::string words{quantity};
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

int decimals_for(double largest) {
  if (!(std::isfinite(largest) && largest > 0.0)) return 3;
  return std::clamp(3 - static_cast<int>(std::floor(std::log10(largest))), 0, 6);
}

std::string with_decimals(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  constexpr double longest = 1e12;
  return std::abs(value) < longest ? to_fixed(value, decimals) : to_significant(value, 4);
}

}  // namespace moat
