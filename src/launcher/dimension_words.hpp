// Dimensions in the words of a reader of scripts: "a force [N]", "a number without unit".
#pragma once

#include <algorithm>
#include <array>
#include <regex>
#include <string>

#include "base/known_units.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {

struct Dimension {
  KnownUnit type;  // the name of a quantity's type, and exponents
  std::string_view words, unit;
};

inline constexpr std::string_view number = "a number without unit";
inline constexpr std::array dimensions{
    Dimension{known_unit("double", Dimensionless{}), number, ""},
    Dimension{known_unit("int", Dimensionless{}), number, ""},
    Dimension{known_unit("Mass", Mass{}), "a mass [kg]", "kg"},
    Dimension{known_unit("Length", Length{}), "a length [m]", "m"},
    Dimension{known_unit("Time", Time{}), "a time [s]", "s"},
    Dimension{known_unit("Frequency", Frequency{}), "a frequency [1/s]", "Hz"},
    Dimension{known_unit("Speed", Speed{}), "a speed [m/s]", "m / s"},
    Dimension{known_unit("Acceleration", Acceleration{}), "an acceleration [m/s^2]", "m / (s * s)"},
    Dimension{known_unit("Force", Force{}), "a force [N]", "N"},
    Dimension{known_unit("Energy", Energy{}), "an energy [J = N m]", "J"},
    Dimension{known_unit("Stiffness", Stiffness{}), "a stiffness [N/m]", "N / m"},
    Dimension{known_unit("DampingCoefficient", DampingCoefficient{}), "a damping coefficient [N s/m]", "N * s / m"},
    Dimension{known_unit("HertzStiffness", HertzStiffness{}), "a Hertz stiffness [N/m^1.5]", "N / m_3_2"},
    Dimension{known_unit("Area", Area{}), "an area [m^2]", "m_2"},
    Dimension{known_unit("SecondMoment", SecondMoment{}), "a second moment of area [m^4]", "m_4"},
    Dimension{known_unit("Density", Density{}), "a density [kg/m^3]", "kg / m_3"},
    Dimension{known_unit("Modulus", Modulus{}), "a modulus [Pa]", "Pa"},
};

inline std::string words_of(const KnownUnit& unit) {
  for (const auto& [type, words, in_script] : dimensions)
    if (type.mass == unit.mass && type.half_length == unit.half_length && type.time == unit.time)
      return std::string{words};
  return "a quantity in " + unit_symbol(unit.mass, unit.half_length, unit.time);
}

/// Returns the dimension of a type such as "Required<Force>" or "moat::Quantity<1, 2, -2>"; empty where it has none.
inline std::string dimension_of_type(const std::string& type) {
  static const std::regex quantity{R"(.*\bQuantity<(-?\d{1,2}), ?(-?\d{1,2}), ?(-?\d{1,2})>[ >&]*)"};
  static const std::regex innermost{R"((?!std::vector|std::function)(?:.*\W)?(\w+)[ >&]*)"};
  std::smatch match;
  if (type.size() > longest_line) return "";
  if (std::regex_match(type, match, quantity))
    return words_of({"", 1.0, std::stoi(match[1]), std::stoi(match[2]), std::stoi(match[3])});
  if (!std::regex_match(type, match, innermost)) return "";
  for (const auto& [known, words, unit] : dimensions)
    if (known.name == match[1].str()) return std::string{words};
  return "";
}

/// Returns the dimension of a product of numbers and units, such as `100 * MN / m`; empty for every other expression,
/// and for a unit that the script, `code`, declares itself.
inline std::string dimension_of_value(const std::string& value, const std::string& code) {
  static const std::regex number_of_script{R"([-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?)"};
  static constexpr auto units = common_units_and(
      std::array{known_unit("m_3_2", units::m_3_2), known_unit("m_2", units::m_2), known_unit("cm_2", units::cm_2),
                 known_unit("mm_2", units::mm_2), known_unit("m_3", units::m_3), known_unit("m_4", units::m_4),
                 known_unit("cm_4", units::cm_4), known_unit("mm_4", units::mm_4), known_unit("Pa", units::Pa),
                 known_unit("kPa", units::kPa), known_unit("MPa", units::MPa), known_unit("GPa", units::GPa)});
  KnownUnit product;
  int sign = 1;
  if (value.size() > longest_line) return "";
  for (std::size_t begin = 0, end = 0; end < value.size() || begin == 0; begin = end + 1) {
    end = std::min(value.find_first_of("*/", begin), value.size());
    const std::string factor = trimmed(value.substr(begin, end - begin));
    const auto* const unit = std::ranges::find(units, factor, &KnownUnit::name);
    if (unit != units.end() && code.find(" " + factor + " =") == std::string::npos)
      product = {"", 1.0, product.mass + sign * unit->mass, product.half_length + sign * unit->half_length,
                 product.time + sign * unit->time};
    else if (!std::regex_match(factor, number_of_script))
      return "";
    sign = end < value.size() && value[end] == '/' ? -1 : 1;
  }
  return words_of(product);
}

/// "0.1 is a number without unit, but a length [m] is needed; ..."; empty where both are equal, or one is unknown.
inline std::string misfit(const std::string& value, const std::string& given, const std::string& needed) {
  if (given.empty() || needed.empty() || given == needed) return "";
  const std::string sentence = value + " is " + given + ", but " + needed + " is needed";
  const auto* const known = std::ranges::find(dimensions, needed, &Dimension::words);
  if (given != number || value == "this" || known == dimensions.end()) return sentence;
  return sentence + "; give it a unit, as in " + value + " * " + std::string{known->unit};
}

}  // namespace moat::launcher
