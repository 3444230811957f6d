#include "design/design_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/text/number_format.hpp"

namespace moat {

std::string_view name_of(Bound bound) {
  constexpr std::array<std::string_view, 3> names{"lower bounds", "nominal", "upper bounds"};
  return names[static_cast<std::size_t>(bound)];
}

double SheetLine::value(Bound bound) const {
  if (values.empty()) throw InputError{"SheetLine: \"" + symbol + "\" has no value."};
  return values.size() == 1 ? values.front() : values[static_cast<std::size_t>(bound)];
}

const SheetLine& DesignSheet::line(std::string_view symbol) const {
  const auto found = std::ranges::find(lines, symbol, &SheetLine::symbol);
  if (found != lines.end()) return *found;
  std::string all;
  for (const SheetLine& each : lines) all += (all.empty() ? "" : ", ") + each.symbol;
  throw InputError{"DesignSheet: there is no line \"" + std::string{symbol} + "\". The lines are " + all + "."};
}

std::vector<const SheetLine*> DesignSheet::rules() const {
  std::vector<const SheetLine*> found;
  for (const SheetLine& each : lines)
    if (!each.verdict.empty()) found.push_back(&each);
  std::ranges::stable_sort(found, {}, [](const SheetLine* each) {
    return each->symbol == "gap" ? 0 : each->is_kept == false ? 1 : each->is_kept ? 3 : 2;
  });
  return found;
}

std::string sheet_value(double value_in_si, std::string_view unit) {
  constexpr double longest = 1000.0;  // with a point in 4 digits
  const bool kilo = unit.starts_with("N");
  const double value = kilo ? 1e-3 * value_in_si : value_in_si;
  return (std::abs(value) >= longest ? to_fixed(value, 0) : to_significant(value, 4)) +
         (unit == "1" ? "" : (kilo ? " k" : " ") + std::string{unit});
}

}  // namespace moat
