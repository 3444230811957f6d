// The program `moat`, which the bootstrap script of that name builds and calls with three folders (places.hpp) before
// the user's words.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <new>
#include <string_view>

#include "base/nearest_name.hpp"
#include "launcher/bench.hpp"
#include "launcher/checks.hpp"
#include "launcher/completion.hpp"
#include "launcher/doctor.hpp"
#include "launcher/help.hpp"
#include "launcher/installed_text.hpp"
#include "launcher/library_program.hpp"
#include "launcher/new_project.hpp"
#include "launcher/new_script.hpp"
#include "launcher/phase.hpp"
#include "launcher/run_script.hpp"
#include "launcher/stop.hpp"
#include "launcher/tests.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

std::vector<CompletionWords> completion_words() {
  return {{"run",
           {"--ranks", "--out", "--force", "--step", "--tolerance", "--integrator", "--end", "--frame-interval",
            "--check", "--quiet", "--json", "--record", "--record-unit", "--threads", "--case", "--cases", "--retry"},
           true},
          {"new", {}, true},
          {"motion", {"--unit", "--damping", "--out", "--json"}, true},
          {"report", {"--json", "--open"}, true},
          {"study", {"show", "export", "merge", "--out"}, true},
          {"bench", {"paper",         "accuracy", "isolators", "performance", "peers",          "--out",
                     "--write-docs",  "--coarse", "--models",  "--seed",      "--threads",      "--csv",
                     "--only-random", "--only",   "--rounds",  "--quick",     "equal-accuracy", "overhead",
                     "plan",          "scale",    "suite",     "scripts"}},
          {"check", check_names()},
          {"completion", {"bash"}}};
}

void require_sources(const Places& places, const std::string& command) {
  if (places.installed())
    throw Stop{exit_usage, command + " needs the sources of moat, and this is an installed package.\n" +
                               "Clone the sources and call it there."};
}

void require_known_command(const CLI::App& app, const std::string& word) {
  if (word.starts_with('-') || word == "help") return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (std::ranges::find(names, word) != names.end()) return;
  throw Stop{exit_usage, "There is no command " + word + "." + did_you_mean(names, word) + "\nThere are " +
                             joined(names, ", ") + "."};
}

// An option of a command, with the one that is meant if it is misspelt; empty if the words hold no unknown option.
std::string unknown_option(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    std::vector<std::string> names;
    for (const CLI::Option* known : command->get_options())
      names.insert(names.end(), known->get_lnames().begin(), known->get_lnames().end());
    for (const std::string& word : command->remaining()) {
      const std::string option = word.substr(0, word.find('='));
      const std::size_t name = option.find_first_not_of('-');
      if (name == 0 || name == std::string::npos) continue;
      return command->get_name() + " has no option " + option + "." + did_you_mean(names, option.substr(name), "--") +
             "\nSee ./moat " + command->get_name() + " --help.";
    }
  }
  return "";
}

int run_command_line(const Places& places, int count, char** words) {
  CLI::App app{help::moat, places.installed() ? "moat" : "./moat"};
  const auto help_of = [&] { return as_installed(app.help(), places); };
  app.require_subcommand(1);
  app.footer(help::after_moat);

  int code = 0;
  CLI::App* const run = app.add_subcommand("run", help::run)->prefix_command()->footer(help::after_run);
  run->callback([&] { code = run_script(places, run->remaining()); });

  CLI::App* const create = app.add_subcommand("new", help::create)->footer(help::after_new);
  std::string file;
  bool project = false;
  create->add_option("NAME", file, "the file to write, NAME.cpp; with --project the folder")->required();
  create->add_flag("--project", project, "a folder with a project for CMake");
  create->callback([&] { project ? new_project(places, file) : new_script(places, file); });

  CLI::App* const test = app.add_subcommand("test", help::test)->allow_extras()->footer(help::after_test);
  TestOptions test_options;
  test->add_flag("--all", test_options.all, "nothing may be skipped; see below");
  test->callback([&] {
    require_sources(places, "test");
    test_options.words = test->remaining();
    code = run_tests(places, test_options);
  });

  CLI::App* const bench = app.add_subcommand("bench", help::bench)->prefix_command()->footer(help::after_bench);
  bench->callback([&] {
    const std::vector<std::string> rest = bench->remaining();
    for (const std::string& word : rest)
      if (word == "-h" || word == "--help") throw CLI::CallForHelp{};
    require_sources(places, "bench");
    run_benchmark(places, rest);
  });

  const auto library_command = [&](const char* name, const char* argument, const char* description,
                                   const char* footer) {
    CLI::App* const command = app.add_subcommand(name, description)->prefix_command()->footer(footer);
    command->callback([&places, command, argument] {
      const std::vector<std::string> rest = command->remaining();
      const std::string word = command->get_name(), first = rest.empty() ? "" : rest.front();
      if (first == "-h" || first == "--help") throw CLI::CallForHelp{};
      const bool known = word != "study" || first == "show" || first == "export" || first == "merge";
      if (rest.empty() || !known)
        throw Stop{exit_usage, word + " needs " + argument + ".\nSee ./moat " + word + " --help."};
      become_library_program(places, word, rest);
    });
  };
  library_command("motion", "the name of an accelerogram", help::motion, help::after_motion);
  library_command("report", "the folder of results", help::report, help::after_report);
  library_command("study", "one of show, export and merge", help::study, help::after_study);

  CLI::App* const check = app.add_subcommand("check", help::check)->footer(help::after_check);
  std::vector<std::string> names;
  check->add_option("NAME", names, "one or more of " + joined(check_names(), ", ") + "; all if none is given");
  check->callback([&] {
    require_sources(places, "check");
    code = run_checks(places, names);
  });

  CLI::App* const completion = app.add_subcommand("completion", help::completion)->footer(help::after_completion);
  std::string shell;
  completion->add_option("SHELL", shell, "bash")->required()->check(CLI::IsMember({"bash"}));
  completion->callback([&] { std::fputs(bash_completion(app, completion_words()).c_str(), stdout); });

  app.add_subcommand("doctor", help::doctor)->footer(help::after_doctor)->callback([&] {
    code = launcher::doctor(places);
  });

  if (count == 1) {
    std::fputs(help_of().c_str(), stderr);
    return exit_usage;
  }
  require_known_command(app, words[1]);
  static char help_option[] = "--help";
  if (std::string_view{words[1]} == "help") words[1] = help_option;
  try {
    app.parse(count, words);
  } catch (const CLI::CallForHelp&) {
    std::fputs(help_of().c_str(), stdout);
  } catch (const CLI::ParseError& error) {
    if (const std::string unknown = unknown_option(app); !unknown.empty()) throw Stop{exit_usage, unknown};
    throw Stop{exit_usage, std::string{error.what()} + "\nSee ./moat --help."};
  }
  return code;
}

}  // namespace
}  // namespace moat::launcher

int main(int count, char** words) {
  using namespace moat::launcher;
  constexpr int folders = 3;
  Places places;
  try {
    if (count <= folders) throw Stop{exit_usage, "This program is called by the script moat."};
    places = {.root = words[1], .build = words[2], .work = words[3]};
    return run_command_line(places, count - folders, words + folders);
  } catch (const Stop& stop) {
    for (const std::string& line : lines_of(as_installed(stop.what(), places))) say(line);
    return stop.exit_code;
  } catch (const std::bad_alloc&) {
    say("error: the memory is too small. End other programs, or raise its limit (ulimit -v).");
    return exit_failed;
  } catch (const std::exception& error) {
    say(std::string{"error: "} + error.what());
    return exit_failed;
  }
}
