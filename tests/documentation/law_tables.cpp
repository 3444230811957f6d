#include "law_tables.hpp"

#include <array>
#include <concepts>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "impact_cases.hpp"
#include "moat.hpp"

namespace moat::testing {
namespace {

constexpr double mass = 1e5, approach_speed = 0.5;

// The restitution of a free impact for e = 0.80, 0.65, 0.40.
template <class Law>
std::string delivered(bool may_pull) {
  if constexpr (
      !requires(Law law) { law.may_pull; } && !requires(Law law) { law.restitution; })
    return "elastic";
  std::ostringstream text;
  text << std::fixed << std::setprecision(3);
  for (const double e : {0.80, 0.65, 0.40}) {
    Law law = impact_law<Law>(1e9, e);
    if constexpr (requires { law.may_pull; }) law.may_pull = may_pull;
    text << (e == 0.80 ? "" : ", ") << delivered_restitution(law.between(mass), mass, approach_speed);
  }
  return text.str();
}

template <class Law>
std::string row() {
  std::ostringstream text;
  text << "| [`" << Law::name << "`](../../materials/impact/" << option_name(Law::name) << ".hpp)";
  if (!alias_of<Law>().empty()) text << ", also `" << alias_of<Law>() << "`";
  text << " | ";
  const char* separator = "";
  for (const Parameter& parameter : impact_law<Law>(1e9, 0.65).parameters()) {
    text << separator << "`" << parameter.name << "`";
    separator = ", ";
  }
  text << " | " << Law::formula << " | " << delivered<Law>(false);
  // Such laws pull only where the choice makes a difference.
  if (delivered<Law>(true) != delivered<Law>(false)) text << "; " << delivered<Law>(true) << " with `may_pull`";
  text << " |\n";
  return text.str();
}

template <class Contact>
std::string table(const std::string& title, const std::string& formula) {
  std::string text =
      "**" + title + "\n\n| Law | Parameters | " + formula + " | Restitution delivered |\n|---|---|---|---|\n";
  AllImpactLaws::for_each([&]<class Law>() {
    if constexpr (std::same_as<decltype(impact_law<Law>(1e9, 0.65).between(mass)), Contact>) text += row<Law>();
  });
  return text;
}

struct Family {
  std::string folder, title;
};
const std::array<Family, 4> families{Family{"isolation", "Isolators"}, Family{"dampers", "Dampers"},
                                     Family{"storeys", "Storeys"}, Family{"soil", "Soil"}};

std::filesystem::path folder_of(const Family& family) {
  return std::filesystem::path{MOAT_SOURCE_DIR} / "materials" / family.folder;
}

template <class Law>
std::string spring_row(const Family& family) {
  std::ostringstream text;
  text << "| [`" << Law::name << "`](../../materials/" << family.folder << "/" << option_name(Law::name) << ".hpp) | "
       << Law::formula << " | ";
  const char* separator = "";
  for (const Parameter& parameter : Law::typical().parameters()) {
    text << separator << "`" << parameter.name << "` " << to_text(parameter.value);
    if (parameter.unit != "1") text << " " << parameter.unit;
    separator = ", ";
  }
  text << " |\n";
  return text.str();
}

}  // namespace

std::string impact_law_tables() {
  return table<ViscousHertzContact>(
             "Hertz, damping in proportion to the elastic force:** F = k d^1.5 (1 + z d'/v0), k in N/m^1.5", "z") +
         "\n" +
         table<RootDampedHertzContact>(
             "Hertz, damping with the fourth root of the indentation:** F = k d^1.5 + c "
             "d^(1/4) d', c = 2 xi sqrt(k m), k in N/m^1.5",
             "xi") +
         "\n" +
         table<ViscousLinearContact>("Linear spring and dashpot:** F = k d + c d', c = 2 xi sqrt(k m), k in N/m",
                                     "xi") +
         "\n" +
         table<BilinearContact>(
             "Linear springs, one of which yields:** loads with K1 to d_y = a d_m, then with K2; dE = k d_m^2.5 (1 - "
             "e^2)/2.5, K_eff = k d_m^(1/2), k in N/m^1.5",
             "K1, K2");
}

std::string spring_law_tables() {
  std::string text;
  for (const Family& family : families) {
    if (!text.empty()) text += "\n";
    text += "**" + family.title + "**\n\n| Law | Force | Parameters, with typical values |\n|---|---|---|\n";
    AllSpringLaws::for_each([&]<class Law>() {
      if (std::filesystem::exists(folder_of(family) / (option_name(Law::name) + ".hpp")))
        text += spring_row<Law>(family);
    });
  }
  return text;
}

}  // namespace moat::testing
