#include <ctime>
#include <filesystem>
#include <moat.hpp>
#include <string>
#include <vector>

#include "measuring/measure.hpp"
#include "paper/paper_building.hpp"
#include "paper/records.hpp"
#include "performance/sections.hpp"

namespace moat::performance {

using namespace units;

namespace {

struct Taken {
  double wall = 0.0, cpu = 0.0;  // s; CPU time of all threads
};

/// By a study with a file that keeps its cases.
Taken by_study(const std::vector<GroundMotion>& motions, int gaps, int threads, const Integrator& integrator) {
  const double wall = seconds(Clock::wall), cpu = static_cast<double>(std::clock());
  const StudyCases cases{{.name = "gap", .unit = "cm", .values = linearly_spaced(10, 50, gaps)},
                         StudyAxis::of_names("record", paper::record_labels())};
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "moat_benchmark_suite";
  std::filesystem::remove_all(folder);
  StudyStore store{folder / "study.db", cases, {}, {}};
  run_study(cases,
            [&](const StudyCase& each) {
              StudyModel one{Model{}, motions[each.position("record")]};
              paper::add_pounding(one.model, {}, each.value("gap") * cm);
              return one;
            },
            {.threads = threads, .transient = {.integrator = integrator}, .store = &store});
  return {seconds(Clock::wall) - wall, (static_cast<double>(std::clock()) - cpu) / CLOCKS_PER_SEC};
}

}  // namespace

void suite(Record& record, const Options& options) {
  record.section("suite");
  if (const std::string missing = paper::missing_records(); !missing.empty()) return record.note(missing);
  const std::vector<GroundMotion> motions = paper::scaled_records();
  const int gaps = options.quick ? 6 : 41;
  const double histories = 4.0 * gaps;
  std::vector<double> per_second, per_second_automatic, one, two;
  for (int round = -1; round < options.rounds; ++round) {
    const Taken on_one = by_study(motions, gaps, 1, Newmark{}), on_two = by_study(motions, gaps, 2, Newmark{}),
                automatic = by_study(motions, gaps, 1, Automatic{});
    if (round < 0) continue;
    per_second.push_back(histories / on_one.cpu);
    per_second_automatic.push_back(histories / automatic.cpu);
    // Waiting counts for the gain of a second core.
    one.push_back(on_one.wall);
    two.push_back(2.0 * on_two.wall);
  }
  Table table{{"Study of " + std::to_string(gaps) + " gaps x 4 motions", "Measured", "Target"}};
  const auto show = [&](const std::string& name, const Spread& value, std::optional<Target> target = {}) {
    table.put(name, "Measured", cell(record.add({"suite, " + name, value, "", target})));
    if (target) table.put(name, "Target", text(*target));
  };
  show("histories per second on one core", spread_of(per_second));
  show("histories per second on one core, integrator chosen automatically", spread_of(per_second_automatic));
  show("time on 1 thread over 2 x time on 2 threads", ratio_of(one, two), Target{0.9, false});
  record.table(table);
}

}  // namespace moat::performance
