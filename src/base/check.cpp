#include "base/check.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/text/number_format.hpp"
#include "base/text/utf8_text.hpp"

namespace moat {
namespace {

std::string with_unit(double value, std::string_view unit) {
  std::string text = to_text(value);
  if (!unit.empty() && unit != "1") text.append(" ").append(unit);
  return text;
}

// The remedy for a value whose caller has no better one.
std::string_view usual_remedy(double value, std::string_view unit) {
  if (!std::isfinite(value)) return "Look for a division by zero in the calculation that gave it.";
  if (unit.empty() || unit == "1") return "Give a number in this range.";
  return "Check its sign and its unit.";
}

}  // namespace

std::string to_text(double value) { return to_significant(value, 6); }

// Kind "name"
std::string Check::object() const {
  std::string text{kind_};
  if (!name_.empty()) text.append(" \"").append(name_).append("\"");
  return text;
}

void Check::that(bool allowed, std::string_view parameter, double value, std::string_view unit, std::string_view range,
                 std::string_view advice) const {
  if (allowed) return;
  std::string message = object() + ": ";
  message.append(parameter).append(" = ").append(with_unit(value, unit)).append(" is not allowed; it must be ");
  message.append(range).append(".");
  message.append(" ").append(advice.empty() ? usual_remedy(value, unit) : advice);
  throw InputError{message};
}

void Check::fits_tables(std::string_view name) const {
  that(is_utf8(name), "the name is not UTF-8.", "Save the script in UTF-8.");
  that(name.empty() || std::string_view{"=+-@"}.find(name.front()) == std::string_view::npos,
       "the name begins with = + - or @.",
       "Spreadsheets take that for a formula; let the name begin with a letter or a digit.");
}

void Check::refuse(std::string_view problem, std::string_view advice) const {
  std::string message = object() + ": ";
  message.append(problem);
  if (!advice.empty()) message.append(" ").append(advice);
  throw InputError{message};
}

void Check::positive(std::string_view parameter, double value, std::string_view unit, std::string_view advice) const {
  if (std::isfinite(value) && value > 0.0) return;
  that(false, parameter, value, unit, "> " + with_unit(0.0, unit) + " and finite", advice);
}

void Check::not_negative(std::string_view parameter, double value, std::string_view unit,
                         std::string_view advice) const {
  if (std::isfinite(value) && value >= 0.0) return;
  that(false, parameter, value, unit, ">= " + with_unit(0.0, unit) + " and finite", advice);
}

void Check::finite(std::string_view parameter, double value, std::string_view unit, std::string_view advice) const {
  that(std::isfinite(value), parameter, value, unit, "a finite number", advice);
}

void Check::above_up_to(std::string_view parameter, double value, double lowest, double highest, std::string_view unit,
                        std::string_view advice) const {
  if (value > lowest && value <= highest) return;
  that(false, parameter, value, unit, "> " + with_unit(lowest, unit) + " and <= " + with_unit(highest, unit), advice);
}

void Check::between(std::string_view parameter, double value, double lowest, double highest, std::string_view unit,
                    std::string_view advice) const {
  if (value >= lowest && value <= highest) return;
  that(false, parameter, value, unit, "from " + with_unit(lowest, unit) + " to " + with_unit(highest, unit), advice);
}

}  // namespace moat
