#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "measuring/command_output.hpp"
#include "measuring/measure.hpp"
#include "performance/sections.hpp"

namespace moat::performance {
namespace {

namespace fs = std::filesystem;

/// Seconds from the command to its end, on the wall clock.
double seconds_of(const std::string& command) {
  const double start = seconds(Clock::wall);
  output_of(command + " 2>&1");
  return seconds(Clock::wall) - start;
}

std::vector<fs::path> copies_of_tours(const fs::path& folder) {
  fs::create_directories(folder);
  std::vector<fs::path> copies;
  for (const auto& tour : fs::directory_iterator{fs::path{MOAT_CHECKOUT} / "examples"}) {
    if (tour.path().extension() != ".cpp") continue;
    copies.push_back(folder / tour.path().filename());
    fs::copy_file(tour.path(), copies.back(), fs::copy_options::overwrite_existing);
  }
  std::ranges::sort(copies);
  // The cost of every script.
  copies.push_back(folder / "empty.cpp");
  std::ofstream{copies.back()} << "#include <moat.hpp>\n\nint main() {}\n";
  return copies;
}

// With --help a tour starts, reads its options and ends. A tour without options computes.
void measure_starts(Record& record, const fs::path& folder, const std::string& run, int rounds) {
  Table table{{"Tour", "edited [s]", "unchanged [s]"}};
  for (const fs::path& tour : copies_of_tours(folder)) {
    const std::string start = run + shell_quoted(tour) + " --help";
    std::vector<double> edited, unchanged;
    for (int round = -1; round < rounds; ++round) {
      std::ofstream{tour, std::ios::app} << "// edit " << round << '\n';
      const double first = seconds_of(start), second = seconds_of(start);
      if (round < 0) continue;
      edited.push_back(first);
      unchanged.push_back(second);
    }
    const std::string name = tour.stem().string();
    const auto show = [&](const std::string& state, const std::vector<double>& times, double bound) {
      table.put(name, state + " [s]", cell(record.add({name + ", " + state, spread_of(times), "s", Target{bound}})));
    };
    show("edited", edited, 1.5);
    show("unchanged", unchanged, 0.3);
  }
  record.table(table);
}

void measure_run(Record& record, const fs::path& folder, const std::string& run, int rounds) {
  const fs::path tour = folder / "01_moat_wall.cpp";
  std::vector<double> times;
  for (int round = -1; round < rounds; ++round) {
    // Results stay until the end: a file system may search long for places beside files that were just removed.
    const fs::path results = folder / ("results " + std::to_string(round + 1));
    const double time = seconds_of(run + shell_quoted(tour) + " --out " + shell_quoted(results));
    if (round >= 0) times.push_back(time);
  }
  const Figure& figure = record.add({"tour 1 with all its files", spread_of(times), "s"});
  record.note("The whole run of tour 1 with all its files [s]: " + cell(figure) + ".");
}

}  // namespace

void scripts(Record& record, const Options& options) {
  record.section("scripts");
  const fs::path folder = fs::absolute(options.folder) / "scripts";
  const std::string run = shell_quoted(fs::path{MOAT_CHECKOUT} / "moat") + " run ";
  const int rounds = options.quick ? 1 : options.rounds;
  measure_starts(record, folder, run, rounds);
  measure_run(record, folder, run, 4 * rounds);
  fs::remove_all(folder);
}

}  // namespace moat::performance
