#include "launcher/tests.hpp"

#include <cstdio>
#include <thread>

#include "launcher/library.hpp"
#include "launcher/process.hpp"
#include "launcher/records.hpp"
#include "launcher/skipped_tests.hpp"
#include "launcher/stop.hpp"

namespace moat::launcher {

int run_tests(const Places& places, const TestOptions& options) {
  const bool records = find_records("test");
  if (options.all && !records)
    throw Stop{exit_usage,
               "test --all needs the recorded ground motions, and MOAT_RECORDS is not set.\n"
               "For example: MOAT_RECORDS=~/records ./moat test --all"};
  Part part{.what = "the library and the tests",
            .targets = {"all", "moat_for_scripts"},
            .package_lists = {"test"},
            .cmake_option = "MOAT_BUILD_TESTS"};
  if (options.all) part.package_lists.emplace_back("all");
  bring_up_to_date(places, part);
  if (options.all) unpack_packages(places, "unpacked");

  const std::filesystem::path report = places.build / "test_report.xml";
  std::filesystem::remove(report);
  Command command{"ctest",
                  "--test-dir",
                  places.build,
                  "--output-on-failure",
                  "--no-tests=error",
                  "--output-junit",
                  report,
                  "--parallel",
                  std::to_string(std::thread::hardware_concurrency())};
  command.insert(command.end(), options.words.begin(), options.words.end());
  int code = run(command);

  const std::vector<SkippedTest> skipped = skipped_tests(report);
  if (!skipped.empty()) std::printf("\nSkipped, %zu in all:\n", skipped.size());
  for (const SkippedTest& test : skipped) std::printf("  %s: %s\n", test.name.c_str(), test.reason.c_str());
  if (options.all && !skipped.empty() && code == 0) {
    std::puts("With --all a skipped test is a failure.");
    code = exit_failed;
  }
  if (!records)
    std::puts("MOAT_RECORDS is not set: tests that need recorded ground motions are skipped (./moat test --help).");
  return code;
}

}  // namespace moat::launcher
