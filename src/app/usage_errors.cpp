#include "app/usage_errors.hpp"

#include <algorithm>
#include <iostream>
#include <vector>

#include "base/text/nearest_name.hpp"
#include "base/text/terminal.hpp"

namespace moat {
namespace {

bool is_option(const std::string& word) { return word.size() > 1 && word.front() == '-' && word != "--"; }

std::string unknown_option(const CLI::App& parser, const std::string& program, const std::string& word) {
  const std::string option = word.substr(0, word.find('='));
  const std::string name = option.substr(std::min(option.find_first_not_of('-'), option.size()));
  std::vector<std::string> names;
  for (const CLI::Option* known : parser.get_options())
    names.insert(names.end(), known->get_lnames().begin(), known->get_lnames().end());
  return program + " has no option " + option + "." + did_you_mean(names, name, "--");
}

}  // namespace

std::string usage_error(const CLI::App& parser, const std::string& program, const CLI::ParseError& error) {
  std::string lines;
  bool behind_unknown = false;  // such a word is the value of the unknown option
  for (const std::string& word : parser.remaining(true)) {
    if (is_option(word))
      lines += "moat: error: " + unknown_option(parser, program, word) + "\n";
    else if (!behind_unknown)
      lines +=
          "moat: error: \"" + word + "\" belongs to no option. A value with a blank stands in quotes: \"12 cm\".\n";
    behind_unknown = is_option(word) && word.find('=') == std::string::npos;
  }
  if (lines.empty()) lines = "moat: error: " + std::string{error.what()} + "\n";
  return lines + "moat: --help lists all options.\n";
}

int run_command(CLI::App& parser, const std::string& name, int argc, char** argv, const std::function<int()>& work) {
  try {
    parser.parse(argc, argv);
    return work();
  } catch (const CLI::Success& wish) {
    return parser.exit(wish);
  } catch (const CLI::ParseError& error) {
    print_text(std::cerr, usage_error(parser, name, error));
    return 2;
  } catch (const std::exception& error) {
    print_text(std::cerr, std::string{"moat: error: "} + error.what() + "\n");
    return 1;
  }
}

}  // namespace moat
