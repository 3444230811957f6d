#include <cstddef>
#include <functional>
#include <moat.hpp>
#include <string>
#include <vector>

#include "benchmark_building.hpp"
#include "measuring/command_output.hpp"
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

// How a row of the table adds its building; the benchmark must outlive it.
struct Row {
  std::string name;
  std::function<DiaphragmId(Model&)> add_to;
};

std::vector<Row> rows_of(const BenchmarkBuilding& benchmark) {
  return {{"24 x 24 matrices", [&](Model& model) { return add(model, benchmark.from_matrices()).base; }},
          {"24 modes", [&](Model& model) { return add(model, benchmark.from_modes()).base; }},
          {"9 modes",
           [&](Model& model) {
             Superstructure nine = benchmark.from_modes();
             nine.modes->keep = 9;
             return add(model, nine).base;
           }},
          {"PlanBuilding of 8 storeys", [&](Model& model) { return add_plan_building(model, benchmark); }}};
}

struct Taken {
  double seconds = 0.0, steps = 0.0;
};

Taken history(const BenchmarkBuilding& benchmark, const Row& row, const GroundMotion& motion) {
  Model model;
  const DiaphragmId base = row.add_to(model);
  benchmark.add_dashpots(model, base);
  BenchmarkBuilding::add_walls(model, base);
  const double start = seconds(Clock::thread);
  CaseRun run{model, motion, {.error_bars = ErrorBarMode::never}};
  run.run();
  const double time = seconds(Clock::thread) - start;
  return {time, static_cast<double>(run.result().solver.accepted_steps)};
}

}  // namespace

double superstructure_bytes(std::size_t row) {
  const BenchmarkBuilding benchmark;
  history(benchmark, rows_of(benchmark).at(row), testing::newhall(true));
  return peak_resident_bytes();
}

void superstructures(Record& record, const Options& options) {
  record.section("superstructures");
  if (testing::folder_of_experiment("smart_base_isolated").empty())
    return record.note("MOAT_EXPERIMENTS is not set: the benchmark building is not measured.");
  const BenchmarkBuilding benchmark;
  const std::vector<Row> rows = rows_of(benchmark);
  const GroundMotion motion = testing::newhall(true);
  std::vector<std::vector<double>> times(rows.size());
  std::vector<double> steps(rows.size());
  for (int round = -1; round < (options.quick ? 1 : options.rounds); ++round)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Taken taken = history(benchmark, rows[i], motion);
      if (round >= 0) times[i].push_back(taken.seconds);
      steps[i] = taken.steps;
    }
  const std::string time = "time of a run [s]", memory = "peak memory of the process [MB]";
  Table table{{"Benchmark building in its walls, 30 s of Newhall", time, "steps", memory}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto put = [&](const std::string& column, const std::string& quantity, const Spread& value,
                         const char* unit) {
      table.put(rows[i].name, column,
                cell(record.add({"benchmark building, " + rows[i].name + quantity, value, unit})));
    };
    put(time, "", spread_of(times[i]), "s");
    put("steps", ", steps", single(steps[i]), "");
    const double bytes = std::stod(output_of_this_program("superstructure --row " + std::to_string(i)));
    put(memory, ", peak memory of the process", single(1e-6 * bytes), "MB");
  }
  record.table(table);
  record.note(
      "92 linear bearings with 184 dashpots, all peaks and histories; without error bars. The memory is that of a "
      "whole "
      "process with one such history.");
}

}  // namespace moat::performance
