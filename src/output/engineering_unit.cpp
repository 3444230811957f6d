#include "output/engineering_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace moat {

EngineeringUnit engineering_unit(std::string_view si_symbol) {
  if (si_symbol == "m") return {"cm", 100.0};
  if (si_symbol == "m/s") return {"cm/s", 100.0};
  if (si_symbol == "N") return {"kN", 1e-3};
  if (si_symbol == "J") return {"kJ", 1e-3};
  return {std::string{si_symbol}, 1.0};
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
  std::array<char, 352> text;  // the largest double has 309 digits before the point
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

}  // namespace moat
