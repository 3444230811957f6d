#include "launcher/value_dimension.hpp"

#include <array>
#include <optional>
#include <regex>
#include <string_view>

#include "base/units.hpp"

namespace moat::launcher {
namespace {

struct Exponents {
  int mass = 0, half_length = 0, time = 0;
};

struct Unit {
  std::string_view name;
  Exponents exponents;
};

template <class Q>
constexpr Unit unit(std::string_view name, Q) {
  return {name, {Q::mass_exponent, Q::half_length_exponent, Q::time_exponent}};
}

constexpr std::array known_units{
    unit("m", units::m),           unit("mm", units::mm),       unit("cm", units::cm),
    unit("km", units::km),         unit("s", units::s),         unit("ms", units::ms),
    unit("kg", units::kg),         unit("tonne", units::tonne), unit("N", units::N),
    unit("kN", units::kN),         unit("MN", units::MN),       unit("GN", units::GN),
    unit("J", units::J),           unit("kJ", units::kJ),       unit("MJ", units::MJ),
    unit("Hz", units::Hz),         unit("g", units::g),         unit("m_3_2", units::m_3_2),
    unit("minute", units::minute), unit("pi", Dimensionless{}), unit("rad", Dimensionless{}),
    unit("deg", Dimensionless{}),
};

std::optional<Exponents> exponents_of(const std::string& factor) {
  if (is_number(factor)) return Exponents{};
  for (const Unit& each : known_units)
    if (each.name == factor) return each.exponents;
  return {};
}

}  // namespace

bool is_number(const std::string& value) {
  static const std::regex number{R"([-+]?([0-9][0-9']*\.?[0-9']*|\.[0-9]+)([eE][-+]?[0-9]+)?)"};
  return std::regex_match(value, number);
}

std::string type_of_product(const std::string& value) {
  static const std::regex factor{R"(\s*([-+]?[\w.']+(?:[eE][-+]\d+)?)\s*([*/]|$))"};
  static const std::regex whole{R"([-+]?[0-9']+)"};
  if (std::regex_match(value, whole)) return "int";
  Exponents product;
  int sign = 1;
  bool complete = false;
  auto rest = value.begin();
  for (std::smatch match; !complete; rest = match[0].second) {
    if (!std::regex_search(rest, value.end(), match, factor, std::regex_constants::match_continuous)) return {};
    const auto exponents = exponents_of(match[1]);
    if (!exponents) return {};
    product.mass += sign * exponents->mass;
    product.half_length += sign * exponents->half_length;
    product.time += sign * exponents->time;
    sign = match[2] == "/" ? -1 : 1;
    complete = match[2].length() == 0;
  }
  if (product.mass == 0 && product.half_length == 0 && product.time == 0) return "double";
  return "Quantity<" + std::to_string(product.mass) + ", " + std::to_string(product.half_length) + ", " +
         std::to_string(product.time) + ">";
}

}  // namespace moat::launcher
