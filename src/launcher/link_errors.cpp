#include "launcher/link_errors.hpp"

#include <algorithm>
#include <regex>
#include <vector>

#include "launcher/dimension_names.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

// The names that have no definition, each once. Those of the library are not the script's.
std::vector<std::string> undefined_names(const std::string& output) {
  static const std::regex undefined{R"(.*undefined reference to [`'](.*)')"};
  std::vector<std::string> names;
  for (const std::string& line : lines_of(with_short_lines(replaced(replaced(output, "‘", "'"), "’", "'")))) {
    std::smatch match;
    if (!matches(line, match, undefined) || match[1].str().starts_with("moat::")) continue;
    if (std::ranges::find(names, match[1]) == names.end()) names.push_back(match[1]);
  }
  return names;
}

}  // namespace

std::string link_explanation(const std::string& output, const std::string& script) {
  std::string text;
  for (const std::string& name : undefined_names(output))
    text += script + ": " +
            (name == "main" ? "the script has no function main; a script needs int main(int argc, char** argv)"
                            : "nothing defines " + with_dimension_names(name) +
                                  ", which the script uses; write its definition in the script") +
            "\n";
  return text;
}

}  // namespace moat::launcher
