#include "launcher/checks.hpp"

#include <algorithm>
#include <iostream>
#include <thread>

#include "base/terminal.hpp"
#include "launcher/library.hpp"
#include "launcher/phase.hpp"
#include "launcher/records.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"
#include "launcher/without_progress.hpp"

namespace moat::launcher {
namespace {

// One command of a check, and its line of progress.
struct Step {
  std::string detail;
  Command command;
};

struct NamedCheck {
  std::string name;
  std::vector<Step> (*steps)(const Places& places);
};

Command in_checkout(const Places& places, const std::string& shell_command) {
  return {"sh", "-c", "cd " + shell_quoted(places.root) + " && " + shell_command};
}

// A build folder of its own beside `release`, configured with the preset of its name. A build does not stop at the
// first error, so that all of them are known at once.
std::vector<Step> preset_steps(const Places& places, const std::string& preset, const std::string& detail) {
  const std::filesystem::path folder = places.work / preset;
  return {{detail + ": configure", {"cmake", "-S", places.root, "-B", folder, "--preset", preset}},
          {detail + ": build", {"cmake", "--build", folder, "--", "-k", "0"}}};
}

Command ctest(const std::filesystem::path& folder, const std::string& only = "") {
  Command command{"ctest",
                  "--test-dir",
                  folder,
                  "--output-on-failure",
                  "--no-tests=error",
                  "--parallel",
                  std::to_string(std::thread::hardware_concurrency())};
  if (!only.empty()) command.insert(command.end(), {"-R", only});
  return command;
}

std::vector<Step> format_steps(const Places& places) {
  return {{"clang-format", in_checkout(places,
                                       "git ls-files -z '*.cpp' '*.hpp' | "
                                       "xargs -0 clang-format --dry-run -Werror")}};
}

std::vector<Step> shell_steps(const Places& places) {
  return {{"shellcheck", in_checkout(places, "git ls-files -z moat .ci '*.sh' | xargs -0 shellcheck")}};
}

std::vector<Step> warnings_steps(const Places& places) { return preset_steps(places, "dev", "warnings are errors"); }

std::vector<Step> tidy_steps(const Places& places) {
  std::vector<Step> steps = preset_steps(places, "dev", "commands for clang-tidy");
  steps.back() = {"headers that a build makes",
                  {"cmake", "--build", places.work / "dev", "--target", "moat_generated_headers"}};
  const std::string files = "^" + regex_quoted(places.root) + "/(src|materials|elements|structures|analyses)/.*\\.cpp$";
  steps.push_back(
      {"clang-tidy", in_checkout(places, "run-clang-tidy -quiet -p " + shell_quoted(places.work / "dev") +
                                             " -extra-arg=-Wno-unknown-warning-option " + shell_quoted(files))});
  return steps;
}

std::vector<Step> package_steps(const Places& places) {
  return {{"a program that uses the installed package", ctest(places.build, "^package\\.")}};
}

std::vector<Step> sanitizers_steps(const Places& places) {
  std::vector<Step> steps = preset_steps(places, "asan", "address and undefined-behaviour sanitizers");
  steps.push_back({"all tests with sanitizers", ctest(places.work / "asan")});
  return steps;
}

const std::vector<NamedCheck> checks{{"format", format_steps},   {"shell", shell_steps},
                                     {"package", package_steps}, {"warnings", warnings_steps},
                                     {"tidy", tidy_steps},       {"sanitizers", sanitizers_steps}};

bool passes(const Places& places, const NamedCheck& check) {
  for (const Step& step : check.steps(places)) {
    if (phase(places.logs(), check.name, step.detail, step.command) == 0) continue;
    const std::string log = (places.logs() / (check.name + ".log")).string();
    print_text(std::cout, without_progress(text_of(log)));
    say("The whole log: " + log);
    return false;
  }
  return true;
}

}  // namespace

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const NamedCheck& check : checks) names.push_back(check.name);
  return names;
}

int run_checks(const Places& places, std::vector<std::string> names) {
  const std::vector<std::string> known = check_names();
  if (names.empty()) names = known;
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Stop{exit_usage, "There is no check " + name + ".\nThere are " + joined(known, ", ") + "."};
  find_records("check");
  // The others have build folders of their own.
  const bool installs = std::ranges::find(names, "package") != names.end();
  Part part{.what = installs ? "the library and the tests" : "headers that a build makes",
            .targets = {"moat_generated_headers"},
            .package_lists = {"test", "check"},
            .cmake_option = "MOAT_BUILD_TESTS"};
  if (installs) part.targets = {"all", "moat_for_scripts"};
  bring_up_to_date(places, part);
  std::vector<std::string> failed;
  for (const NamedCheck& check : checks)
    if (std::find(names.begin(), names.end(), check.name) != names.end() && !passes(places, check))
      failed.push_back(check.name);
  if (failed.empty())
    say("All checks passed: " + joined(names, ", ") + ".");
  else
    say("Checks that failed: " + joined(failed, ", ") + ".");
  return failed.empty() ? 0 : exit_failed;
}

}  // namespace moat::launcher
