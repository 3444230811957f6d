#include <functional>
#include <moat.hpp>
#include <string>
#include <vector>

#include "benchmark_building.hpp"
#include "measuring/measure.hpp"
#include "performance/sections.hpp"

namespace moat::performance {

using namespace units;

namespace {

using testing::BenchmarkBuilding;

// A building of as many floors, bearings and walls whose storeys are springs.
DiaphragmId add_plan_building(Model& model, const BenchmarkBuilding& benchmark) {
  const Superstructure given = benchmark.from_matrices();
  PlanBuilding building{.outline = given.base->outline,
                        .storeys = 8,
                        .floor_mass = 2100 * tonne,
                        .columns = grid(4, 6, {.stiffness = 40 * MN / m}),
                        .damping = {.ratio = 0.05},
                        .base_mass = given.base->mass};
  building.bearings = given.bearings;
  return add(model, building).base;
}

}  // namespace

void superstructures(Record& record, const Options& options) {
  record.section("superstructures");
  if (testing::folder_of_experiment("smart_base_isolated").empty())
    return record.note("MOAT_EXPERIMENTS is not set: the benchmark building is not measured.");
  const BenchmarkBuilding benchmark;
  Superstructure nine = benchmark.from_modes();
  nine.modes->keep = 9;
  const std::vector<std::pair<std::string, std::function<DiaphragmId(Model&)>>> buildings{
      {"24 x 24 matrices", [&](Model& model) { return add(model, benchmark.from_matrices()).base; }},
      {"24 modes", [&](Model& model) { return add(model, benchmark.from_modes()).base; }},
      {"9 modes", [&](Model& model) { return add(model, nine).base; }},
      {"PlanBuilding of 8 storeys", [&](Model& model) { return add_plan_building(model, benchmark); }}};
  const GroundMotion motion = testing::newhall(true);
  std::vector<std::vector<double>> times(buildings.size());
  std::vector<double> steps(buildings.size());
  for (int round = -1; round < (options.quick ? 1 : options.rounds); ++round)
    for (std::size_t i = 0; i < buildings.size(); ++i) {
      Model model;
      const DiaphragmId base = buildings[i].second(model);
      benchmark.add_dashpots(model, base);
      BenchmarkBuilding::add_walls(model, base);
      const double start = seconds(Clock::thread);
      CaseRun run{model, motion, {.error_bars = ErrorBarMode::never}};
      run.run();
      if (round >= 0) times[i].push_back(seconds(Clock::thread) - start);
      steps[i] = static_cast<double>(run.take_result().solver.accepted_steps);
    }
  Table table{{"Benchmark building in its walls, 30 s of Newhall", "time of a run [s]", "steps"}};
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    const std::string& name = buildings[i].first;
    table.put(name, "time of a run [s]", cell(record.add({"benchmark building, " + name, spread_of(times[i]), "s"})));
    table.put(name, "steps", cell(record.add({"benchmark building, " + name + ", steps", single(steps[i]), ""})));
  }
  record.table(table);
  record.note("92 linear bearings with 184 dashpots, all peaks and histories; without error bars.");
}

}  // namespace moat::performance
