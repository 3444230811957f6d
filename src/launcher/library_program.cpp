#include <algorithm>
#include <cstdlib>

#include "launcher/commands.hpp"
#include "launcher/library.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

// Makes the folder that the environment variable MOAT_RECORDS names absolute, since programs may run in folders of
// their own. Returns false if it is not set.
bool find_records() {
  const char* folder = std::getenv("MOAT_RECORDS");
  if (folder == nullptr || *folder == '\0') return false;
  if (!std::filesystem::is_directory(folder))
    throw Stop{exit_usage,
               "MOAT_RECORDS is " + std::string{folder} + ", which is not a folder.\nSee ./moat test --help."};
  ::setenv("MOAT_RECORDS", std::filesystem::canonical(folder).c_str(), 1);
  return true;
}

}  // namespace

void become_library_program(const Places& places, const std::string& command, const Command& words) {
  bring_up_to_date(places, {.what = "the library", .targets = {"moat_" + command}});
  become(places.build / "bin" / ("moat_" + command), "moat " + command, words);
}

void run_benchmark(const Places& places, const Command& words) {
  const std::vector<std::string> names{"paper", "accuracy", "experiments", "isolators", "performance", "peers"};
  const std::string name = words.empty() ? "" : words.front();
  if (std::ranges::find(names, name) == names.end())
    throw Stop{exit_usage,
               (name.empty() ? "bench needs the name of a benchmark." : "There is no benchmark " + name + ".") +
                   "\nThere are " + joined(names, ", ") + "."};
  find_records();
  Part part{.what = "the library and the benchmark", .targets = {"moat_for_scripts", "moat_bench_" + name}};
  if (name == "performance") {
    part.package_lists = {"bench"};
    part.cmake_option = "MOAT_BENCH_PERFORMANCE";
  }
  bring_up_to_date(places, part);
  const std::filesystem::path program = places.build / "benchmarks" / name / name;
  become(program, program, {words.begin() + 1, words.end()});
}

void run_tests(const Places& places, bool all, const Command& words) {
  if (!find_records() && all)
    throw Stop{exit_usage,
               "test --all needs the recorded ground motions, and MOAT_RECORDS is not set.\n"
               "For example: MOAT_RECORDS=~/records ./moat test --all"};
  Part part{.what = "the library and the tests",
            .targets = {"all", "moat_for_scripts"},
            .package_lists = {"test"},
            .cmake_option = "MOAT_BUILD_TESTS"};
  if (all) part.package_lists.emplace_back("all");
  bring_up_to_date(places, part);
  call_bootstrap(places, {"--test", all ? "all" : "some"}, words);
}

void run_checks(const Places& places, const Command& names) {
  find_records();
  bring_up_to_date(places, {.what = "headers that a build makes",
                            .targets = {"moat_generated_headers"},
                            .package_lists = {"test", "check"},
                            .cmake_option = "MOAT_BUILD_TESTS"});
  call_bootstrap(places, {"--check"}, names);
}

void run_fuzzer(const Places& places, const std::string& target, int seconds) {
  find_records();
  bring_up_to_date(places, {.what = "the launcher", .targets = {"moat_launcher"}, .package_lists = {"check"}});
  call_bootstrap(places, {"--fuzz"}, {target, std::to_string(seconds)});
}

}  // namespace moat::launcher
