// The program `moat`, which the bootstrap script of that name builds and calls with three folders (places.hpp) before
// the user's words.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string_view>

#include "base/text/nearest_name.hpp"
#include "base/text/terminal.hpp"
#include "launcher/commands.hpp"
#include "launcher/help.hpp"
#include "launcher/process.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

void doctor(const Places& places) {
  if (!places.installed()) become(places.root / "moat", "moat", {"doctor"});
  std::printf("library        %s\nscripts, logs  %s\n", places.build.c_str(), places.work.c_str());
  std::puts("moat is installed as a package: apt looks after the packages that it needs.");
}

// Words that the parser refuses, with the command or option that is meant if one is misspelt.
[[noreturn]] void refuse(const CLI::App& app, const std::string& first, const std::string& reason) {
  Command names;
  if (app.get_subcommands().empty()) {
    for (const auto& command : help::commands) names.emplace_back(command.name);
    throw Stop{exit_usage, "There is no command " + first + "." + did_you_mean(names, first) + "\nThere are " +
                               joined(names, ", ") + "."};
  }
  const CLI::App& command = *app.get_subcommands().front();
  for (const CLI::Option* known : command.get_options())
    names.insert(names.end(), known->get_lnames().begin(), known->get_lnames().end());
  std::string text = reason;
  for (const std::string& word : command.remaining())
    if (word.starts_with("--"))
      text = first + " has no option " + word + "." + did_you_mean(names, word.substr(2), "--");
  throw Stop{exit_usage, text + "\nSee ./moat " + first + " --help."};
}

int run_command_line(const Places& places, int count, char** words) {
  CLI::App app{help::moat, places.installed() ? "moat" : "./moat"};
  const auto help_of = [&] { return places.adapted(app.help()); };
  app.require_subcommand(1);
  app.footer(help::after_moat);
  for (const auto& [name, description, footer] : help::commands) app.add_subcommand(name, description)->footer(footer);

  // A command that hands on its words, all but --help in front.
  const auto hand_on = [&](const char* name, auto action) {
    CLI::App* const command = app.get_subcommand(name)->prefix_command();
    command->callback([=] {
      const Command rest = command->remaining();
      if (!rest.empty() && (rest.front() == "-h" || rest.front() == "--help")) throw CLI::CallForHelp{};
      action(rest);
    });
  };
  int ranks = 0;
  app.get_subcommand("run")->add_option("--ranks", ranks, "processes of MPI")->check(CLI::Range(1, 4096));
  hand_on("run", [&](const Command& rest) { run_script(places, ranks, rest); });
  hand_on("bench", [&](const Command& rest) { run_benchmark(places, rest); });
  for (const std::string command : {"motion", "report", "study"})
    hand_on(command.c_str(), [&, command](const Command& rest) { become_library_program(places, command, rest); });

  CLI::App* const create = app.get_subcommand("new");
  std::string file;
  bool project = false;
  create->add_option("NAME", file, "the file to write, NAME.cpp; with --project the folder")->required();
  create->add_flag("--project", project, "a folder with a project for CMake");
  create->callback([&] { project ? new_project(places, file) : new_script(places, file); });

  CLI::App* const test = app.get_subcommand("test")->allow_extras();
  bool all = false;
  test->add_flag("--all", all, "nothing may be skipped; see below");
  test->callback([&] { run_tests(places, all, test->remaining()); });

  CLI::App* const check = app.get_subcommand("check");
  Command names;
  check->add_option("NAME", names, "one or more of those below; if none is given all but mutants")
      ->check(CLI::IsMember(
          {"format", "shell", "package", "cppcheck", "tidy", "sanitizers", "threads", "fuzz", "faults", "mutants"}));
  check->callback([&] { run_checks(places, names); });

  CLI::App* const fuzz = app.get_subcommand("fuzz");
  std::string target;
  int seconds = 60;
  fuzz->add_option("TARGET", target, "one of those below")
      ->required()
      ->check(CLI::IsMember({"record", "record_table", "matrix", "sap2000", "table", "spectrum", "quantity",
                             "command_line", "checkpoint", "study_file", "compile_errors"}));
  fuzz->add_option("SECONDS", seconds, "how long")->check(CLI::Range(1, 1'000'000));
  fuzz->callback([&] { run_fuzzer(places, target, seconds); });

  CLI::App* const completion = app.get_subcommand("completion");
  std::string shell;
  completion->add_option("SHELL", shell, "bash")->required()->check(CLI::IsMember({"bash"}));
  completion->callback([] { std::fputs(help::bash_completion, stdout); });
  app.get_subcommand("doctor")->callback([&] { doctor(places); });

  for (const std::string name : {"bench", "test", "check", "fuzz"})
    app.get_subcommand(name)->preparse_callback([&places, name](std::size_t) {
      if (!places.installed()) return;
      throw Stop{exit_usage, name + " needs the sources of moat, and this is an installed package.\n" +
                                 "Clone the sources and call it there."};
    });

  if (count == 1) {
    std::fputs(help_of().c_str(), stderr);
    return exit_usage;
  }
  static char help_option[] = "--help";
  if (std::string_view{words[1]} == "help") words[1] = help_option;
  try {
    app.parse(count, words);
  } catch (const CLI::CallForHelp&) {
    std::fputs(help_of().c_str(), stdout);
  } catch (const CLI::ParseError& error) {
    refuse(app, words[1], error.what());
  }
  return 0;
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
    for (const std::string& line : lines_of(places.adapted(stop.what()))) say(line);
    return stop.exit_code;
  } catch (const std::exception& error) {
    say(std::string{"error: "} + moat::reason_of(error));
    return exit_failed;
  }
}
