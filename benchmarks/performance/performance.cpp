// How fast moat is, as ratios measured in one run. Called by ./moat bench performance.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "performance/equal_accuracy.hpp"
#include "performance/measure.hpp"
#include "performance/options.hpp"
#include "performance/overhead.hpp"
#include "performance/profile.hpp"
#include "performance/record.hpp"
#include "performance/scale.hpp"
#include "performance/street_run.hpp"
#include "performance/suite.hpp"
#include "performance/vector_code.hpp"

namespace {

using namespace moat::performance;

struct Section {
  std::string name;  // for --only
  std::function<void(Record&, const Options&)> run;
};

const std::vector<Section>& sections() {
  static const std::vector<Section> list{
      {"equal-accuracy", equal_accuracy}, {"overhead", overhead}, {"scale", scale}, {"suite", suite},
      {"vector-code", vector_code},       {"profile", profile},
  };
  return list;
}

int run(const Options& options, const std::string& only, bool write_docs) {
  Record record;
  for (const Section& section : sections()) {
    if (!only.empty() && section.name != only) continue;
    const double start = seconds(Clock::wall);
    section.run(record, options);
    std::printf("(%s: %.0f s)\n", section.name.c_str(), seconds(Clock::wall) - start);
  }
  record.write(options.folder);
  if (write_docs) record.write_documentation(MOAT_PERFORMANCE_DOCUMENT);
  std::printf("\nNumbers and charts: %s\n%d targets, %d held, %d missed\n", options.folder.c_str(), record.targets(),
              record.targets() - record.missed(), record.missed());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (const auto exit_code = street_process(argc, argv)) return *exit_code;
  constexpr int exit_usage = 2;
  CLI::App app{"How fast moat is, as ratios measured in one run"};
  app.name("./moat bench performance");
  Options options;
  std::string only, profiled;
  bool write_docs = false;
  std::vector<std::string> names;
  for (const Section& section : sections()) names.push_back(section.name);
  app.add_option("--out", options.folder, "folder for performance.json and the charts")->capture_default_str();
  app.add_flag("--write-docs", write_docs, "also bring docs/performance.md and its charts up to date");
  app.add_option("--only", only, "one section alone")->check(CLI::IsMember(names));
  app.add_option("--rounds", options.rounds, "interleaved rounds whose median counts")
      ->capture_default_str()
      ->check(CLI::Range(5, 1000));
  app.add_option("--profile", profiled, "one hot loop alone, to be watched by a profiler; measures nothing")
      ->check(CLI::IsMember({"building", "exact", "street"}));
  app.add_flag("--quick", options.quick, "less of everything, to try the program");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  }
  try {
    if (const char* records = std::getenv("MOAT_RECORDS")) options.records = records;
    if (write_docs && (options.quick || options.records.empty()))
      throw moat::InputError{"--write-docs needs the recorded motions (MOAT_RECORDS), and not --quick."};
    if (profiled == "building") return profile_building(options), 0;
    if (profiled == "exact") return profile_exact(options), 0;
    if (profiled == "street") return profile_street(), 0;
    return run(options, only, write_docs);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "moat: error: %s\n", error.what());
    return 1;
  }
}
