#include "base/quantity.hpp"

#include <array>
#include <cstdlib>

namespace moat {
namespace {

struct NamedUnit {
  int mass, half_length, time;
  const char* symbol;
};

constexpr std::array named_units{
    NamedUnit{0, 0, 0, "1"},         NamedUnit{1, 0, 0, "kg"},   NamedUnit{0, 2, 0, "m"},
    NamedUnit{0, 0, 1, "s"},         NamedUnit{0, 0, -1, "1/s"}, NamedUnit{0, 2, -1, "m/s"},
    NamedUnit{0, 2, -2, "m/s^2"},    NamedUnit{1, 2, -2, "N"},   NamedUnit{1, 4, -2, "J"},
    NamedUnit{1, 4, -3, "W"},        NamedUnit{1, 0, -2, "N/m"}, NamedUnit{1, 0, -1, "N s/m"},
    NamedUnit{1, -1, -2, "N/m^1.5"}, NamedUnit{1, -2, -2, "Pa"}, NamedUnit{1, -6, 0, "kg/m^3"}};

void append_power(std::string& text, const char* base, int halves) {
  if (halves == 0) return;
  if (!text.empty()) text += ' ';
  text += base;
  if (halves == 2) return;
  text += halves < 0 ? "^-" : "^";
  text += std::to_string(std::abs(halves) / 2);
  if (halves % 2 != 0) text += ".5";
}

}  // namespace

std::string unit_symbol(int mass, int half_length, int time) {
  for (const NamedUnit& unit : named_units)
    if (unit.mass == mass && unit.half_length == half_length && unit.time == time) return unit.symbol;
  std::string text;
  append_power(text, "kg", 2 * mass);
  append_power(text, "m", half_length);
  append_power(text, "s", 2 * time);
  return text;
}

}  // namespace moat
