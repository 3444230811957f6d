#include "spring_law_tables.hpp"

#include <array>
#include <filesystem>
#include <sstream>

#include "base/check.hpp"
#include "materials/contact/named_impact_law.hpp"
#include "materials/spring_laws.hpp"

namespace moat::testing {
namespace {

struct Family {
  std::string folder, title;
};
const std::array<Family, 4> families{Family{"isolation", "Isolators"}, Family{"dampers", "Dampers"},
                                     Family{"storeys", "Storeys"}, Family{"soil", "Soil"}};

std::filesystem::path folder_of(const Family& family) {
  return std::filesystem::path{MOAT_SOURCE_DIR} / "materials" / family.folder;
}

template <class Law>
std::string row(const Family& family) {
  std::ostringstream text;
  text << "| [`" << Law::name << "`](../materials/" << family.folder << "/" << option_name(Law::name) << ".hpp) | "
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

std::string spring_law_tables() {
  std::string text;
  for (const Family& family : families) {
    if (!text.empty()) text += "\n";
    text += "**" + family.title + "**\n\n| Law | Force | Parameters, with typical values |\n|---|---|---|\n";
    AllSpringLaws::for_each([&]<class Law>() {
      if (std::filesystem::exists(folder_of(family) / (option_name(Law::name) + ".hpp"))) text += row<Law>(family);
    });
  }
  return text;
}

std::set<std::string> spring_law_headers() {
  std::set<std::string> headers;
  for (const Family& family : families)
    for (const auto& entry : std::filesystem::directory_iterator{folder_of(family)})
      headers.insert(entry.path().stem());
  return headers;
}

std::set<std::string> spring_law_names() {
  std::set<std::string> names;
  AllSpringLaws::for_each([&]<class Law>() { names.insert(option_name(Law::name)); });
  return names;
}

}  // namespace moat::testing
