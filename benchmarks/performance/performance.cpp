// How fast moat is, as ratios measured in one run. Called by ./moat bench performance.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "base/error.hpp"
#include "measuring/measure.hpp"
#include "measuring/record.hpp"
#include "performance/sections.hpp"
#include "performance/street_run.hpp"

namespace {

using namespace moat::performance;

struct Section {
  std::string name;  // for --only
  std::function<void(Record&, const Options&)> run;
};

const std::vector<Section>& sections() {
  static const std::vector<Section> list{{"equal-accuracy", equal_accuracy},
                                         {"scale", scale},
                                         {"suite", suite},
                                         {"superstructures", superstructures},
                                         {"scripts", scripts}};
  return list;
}

void measure(const Options& options, const std::string& only, bool write_docs) {
  Record record;
  for (const Section& section : sections()) {
    if (!only.empty() && section.name != only) continue;
    const double start = seconds(Clock::wall);
    section.run(record, options);
    std::printf("(%s: %.0f s)\n", section.name.c_str(), seconds(Clock::wall) - start);
  }
  record.write(options.folder);
  if (write_docs) record.write_documentation(MOAT_PERFORMANCE_DOCUMENT);
  std::printf("\nNumbers: %s\n%d targets, %d held, %d missed\n", options.folder.c_str(), record.targets(),
              record.targets() - record.missed(), record.missed());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"How fast moat is, as ratios measured in one run", "moat bench performance"};
  Options options;
  std::string only;
  bool write_docs = false;
  std::vector<std::string> names;
  for (const Section& section : sections()) names.push_back(section.name);
  app.add_option("--out", options.folder, "folder for performance.json")->capture_default_str();
  app.add_flag("--write-docs", write_docs, "also bring docs/performance.md up to date");
  app.add_option("--only", only, "one section alone")->check(CLI::IsMember(names));
  app.add_option("--rounds", options.rounds, "interleaved rounds whose median counts")
      ->capture_default_str()
      ->check(CLI::Range(5, 1000));
  app.add_flag("--quick", options.quick, "less of everything, to try the program");

  StreetSetting street;
  CLI::App* on_street = app.add_subcommand("street", "steps of a street in this process; prints JSON");
  on_street->add_option("--buildings", street.buildings, "of six degrees of freedom each")->capture_default_str();
  on_street->add_option("--steps-before", street.steps_before, "not measured")->capture_default_str();
  on_street->add_option("--steps", street.steps, "measured")->capture_default_str();

  std::size_t row = 0;
  CLI::App* on_superstructure = app.add_subcommand(
      "superstructure", "a history of the section superstructures in this process; prints its peak of memory, bytes");
  on_superstructure->add_option("--row", row, "of its table, from 0")->capture_default_str();

  return moat::run_command(app, "moat bench performance", argc, argv, [&] {
    if (*on_street) return std::printf("%s\n", nlohmann::json(measure_street(street)).dump().c_str()), 0;
    if (*on_superstructure) return std::printf("%.0f\n", superstructure_bytes(row)), 0;
    if (const char* records = std::getenv("MOAT_RECORDS")) options.records = records;
    if (write_docs && (options.quick || options.records.empty() || std::getenv("MOAT_EXPERIMENTS") == nullptr))
      throw moat::InputError{
          "--write-docs needs the recorded motions and experiments (MOAT_RECORDS, MOAT_EXPERIMENTS), and not --quick."};
    measure(options, only, write_docs);
    return 0;
  });
}
