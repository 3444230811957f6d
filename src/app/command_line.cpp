#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "base/error.hpp"
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

CommandLine::CommandLine(int argc, char** argv, std::string title)
    : app_{std::make_unique<CLI::App>(std::move(title))} {
  if (argc > 0) {
    std::filesystem::path program = argv[0];
    // mpirun and srun call the compiled script by its path, which ends in /program.
    const char* source = std::getenv("MOAT_SCRIPT");
    if (source != nullptr && *source != '\0' && program.stem() == "program") program = source;
    // The results of "...cpp" would lie in the folder "..".
    const std::string stem = program.stem().string();
    if (stem != "." && stem != "..") program_ = stem;
    app_->name(program.string());
  }
  for (int i = 1; i < argc; ++i) arguments_.emplace_back(argv[i]);
  for (const std::string& each : arguments_) {
    help_wanted_ = help_wanted_ || each == "-h" || each == "--help";
    json_wanted_ = json_wanted_ || each == "--json";
  }
  app_->get_formatter()->column_width(34);
  app_->footer(
      "Write quantities with their unit: \"12 cm\", 0.4g, \"2.5 ms\".\n"
      "Exit code: 0 done, 1 bad input, 2 wrong usage, 3 a step did not converge,\n"
      "130, 143, 138 or 129 stopped by a signal.");
}

CommandLine::~CommandLine() = default;

std::string CommandLine::help() const { return app_->help(); }

std::string CommandLine::title() const { return app_->get_description(); }

void CommandLine::require_new(const std::string& name) const {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  if (name.empty() || name.front() == '-' || !std::ranges::all_of(name, allowed))
    throw InputError{"Script: \"" + name + "\" cannot be the name of an option. Use letters, digits, - and _."};
  if (app_->get_option_no_throw("--" + name) != nullptr)
    throw InputError{"--" + name +
                     ": there is an option of this name. Name each once; --help lists those of Script itself."};
}

void CommandLine::add_flag(const std::string& name, bool& value, const std::string& help) {
  require_new(name);
  app_->add_flag("--" + name, value, help);
  flags_.emplace_back(name, &value);
}

std::optional<std::string> CommandLine::look_up(const std::string& name, const std::string& preset,
                                                const std::string& help, const std::string& type) {
  require_new(name);
  texts_.emplace_back();
  CLI::Option* option = app_->add_option("--" + name, texts_.back(), help)->type_name(type);
  if (!preset.empty()) option->default_str(preset);
  CLI::App alone;
  alone.set_help_flag();
  alone.allow_extras();
  std::string value;
  const CLI::Option* found = alone.add_option("--" + name, value);
  try {
    // CLI11 takes arguments from the back.
    alone.parse(std::vector<std::string>{arguments_.rbegin(), arguments_.rend()});
  } catch (const CLI::ParseError&) {
    return std::nullopt;  // parse() reads the whole line again and prints the mistake
  }
  const bool given = found->count() > 0 && !help_wanted_;
  if (given || !preset.empty()) known_.emplace_back(name, given ? value : preset);
  return given ? std::optional{value} : std::nullopt;
}

bool CommandLine::parse() {
  try {
    app_->parse(std::vector<std::string>{arguments_.rbegin(), arguments_.rend()});
  } catch (const CLI::ParseError& error) {
    print_text(std::cerr, usage_error(*app_, program_, error));
    return false;
  }
  for (const auto& [name, value] : flags_)
    if (*value) known_.emplace_back(name, "yes");
  return true;
}

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
