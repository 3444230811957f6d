#include "launcher/dimension_names.hpp"

#include <array>
#include <regex>
#include <string_view>

#include "base/quantity.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

struct DimensionName {
  std::array<int, 3> exponents;
  std::string_view type, words;
};

template <class Q>
constexpr DimensionName named(std::string_view type, std::string_view words) {
  return {{Q::mass_exponent, Q::half_length_exponent, Q::time_exponent}, type, words};
}

constexpr std::array names{
    named<Dimensionless>("double", "a number without unit"),
    named<Mass>("Mass", "a mass [kg]"),
    named<Length>("Length", "a length [m]"),
    named<Time>("Time", "a time [s]"),
    named<Frequency>("Frequency", "a frequency [1/s]"),
    named<Speed>("Speed", "a speed [m/s]"),
    named<Acceleration>("Acceleration", "an acceleration [m/s^2]"),
    named<Force>("Force", "a force [N]"),
    named<Energy>("Energy", "an energy [J = N m]"),
    named<Power>("Power", "a power [W]"),
    named<Stiffness>("Stiffness", "a stiffness [N/m]"),
    named<DampingCoefficient>("DampingCoefficient", "a damping coefficient [N s/m]"),
    named<HertzStiffness>("HertzStiffness", "a Hertz stiffness [N/m^1.5]"),
};

std::string name_of(int mass, int half_length, int time) {
  for (const DimensionName& each : names)
    if (each.exponents == std::array{mass, half_length, time}) return std::string{each.type};
  return "quantity in " + unit_symbol(mass, half_length, time);
}

}  // namespace

std::string with_dimension_names(const std::string& text) {
  static const std::regex quantity{R"((?:moat::)?Quantity<(-?\d{1,4}), ?(-?\d{1,4}), ?(-?\d{1,4})>)"};
  static const std::regex required{R"((?:moat::)?Required<([^<>]*?(?:<[^<>]*>)?) ?>)"};
  static const std::regex space{R"(\bmoat::)"};
  if (text.size() > longest_line) return text;
  std::string named;
  auto rest = text.cbegin();
  for (std::sregex_iterator match{text.begin(), text.end(), quantity}, end; match != end; ++match) {
    named.append(rest, (*match)[0].first);
    named += name_of(std::stoi((*match)[1]), std::stoi((*match)[2]), std::stoi((*match)[3]));
    rest = (*match)[0].second;
  }
  named.append(rest, text.cend());
  return replaced(replaced(named, required, "$1"), space, "");
}

std::string described(const std::string& type) {
  std::string name = with_dimension_names(type);
  if (name.starts_with("const ")) name.erase(0, 6);
  for (const DimensionName& each : names)
    if (each.type == name) return std::string{each.words};
  static const std::regex per_storey{R"(PerStorey<(.*?) ?>)"};
  std::smatch match;
  if (matches(name, match, per_storey)) return described(match[1]) + ", or one per storey,";
  if (name == "MemberPoint") return "a node, or a MemberPoint between two,";
  if (name == "Isolation") return "a bearing, such as LeadRubberBearing,";
  if (name == "int") return "a number without unit";
  if (name == "<brace-enclosed initializer list>") return "a list in braces";
  return (std::string{"AEIO"}.find(name.front()) != std::string::npos ? "an " : "a ") + name;
}

}  // namespace moat::launcher
