#include "launcher/value_dimension.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>

#include "base/known_units.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

constexpr auto constants = common_units_and(std::array{
    known_unit("minute", units::minute), known_unit("m_3_2", units::m_3_2), known_unit("pi", Dimensionless{}),
    known_unit("rad", Dimensionless{}), known_unit("deg", Dimensionless{})});

// A number, or a constant of namespace units.
std::optional<KnownUnit> unit_of(const std::string& factor) {
  if (is_number(factor)) return KnownUnit{};
  const auto* const found = std::ranges::find(constants, factor, &KnownUnit::name);
  return found == constants.end() ? std::nullopt : std::optional{*found};
}

}  // namespace

bool is_number(const std::string& value) {
  static const std::regex number{R"([-+]?([0-9][0-9']*\.?[0-9']*|\.[0-9]+)([eE][-+]?[0-9]+)?)"};
  return matches(value, number);
}

std::string type_of_product(const std::string& value) {
  static const std::regex factor{R"(\s*([-+]?[\w.']+(?:[eE][-+]\d+)?)\s*([*/]|$))"};
  if (value.size() > longest_line) return {};
  if (is_number(value) && value.find_first_of(".eE") == std::string::npos) return "int";
  KnownUnit product;
  int sign = 1;
  bool complete = false;
  auto rest = value.begin();
  for (std::smatch match; !complete; rest = match[0].second) {
    if (!std::regex_search(rest, value.end(), match, factor, std::regex_constants::match_continuous)) return {};
    const auto unit = unit_of(match[1]);
    if (!unit) return {};
    product.mass += sign * unit->mass;
    product.half_length += sign * unit->half_length;
    product.time += sign * unit->time;
    sign = match[2] == "/" ? -1 : 1;
    complete = match[2].length() == 0;
  }
  if (product.mass == 0 && product.half_length == 0 && product.time == 0) return "double";
  return "Quantity<" + std::to_string(product.mass) + ", " + std::to_string(product.half_length) + ", " +
         std::to_string(product.time) + ">";
}

}  // namespace moat::launcher
