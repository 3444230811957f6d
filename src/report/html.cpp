#include "report/html.hpp"

#include <cmath>

#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"

namespace moat::html {
namespace {

std::string row(std::string_view name, std::string_view value, std::string_view kind) {
  return "<tr><td>" + escaped(name) + "</td><td class=\"" + std::string{kind} + "\">" + escaped(value) + "</td></tr>\n";
}

}  // namespace

std::string number_row(std::string_view name, std::string_view value) { return row(name, value, "number"); }

std::string text_row(std::string_view name, std::string_view value) { return row(name, value, "text"); }

std::string number_with_unit(double value_in_si, std::string_view si_symbol) {
  constexpr double very_small = 1e-3;
  const EngineeringUnit unit = engineering_unit(si_symbol);
  const double value = unit.per_si * value_in_si, magnitude = std::abs(value);
  const std::string number = magnitude > 0.0 && magnitude < very_small ? to_significant(value, 2)
                                                                       : with_decimals(value, decimals_for(magnitude));
  return number + " " + with_raised_digits(unit.symbol);
}

std::string chart_grid(const std::vector<Chart>& charts, int width, int height) {
  std::string html = "<div class=\"charts\" style=\"--width: " + std::to_string(width) + "px\">\n";
  for (const Chart& chart : charts) html += svg_text({chart}, width, height);
  return html + "</div>\n";
}

std::string wide_picture(const std::string& svg) { return "<div class=\"wide-picture\">\n" + svg + "</div>\n"; }

}  // namespace moat::html
