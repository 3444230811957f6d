#include <boost/math/statistics/linear_regression.hpp>
#include <cmath>
#include <numeric>

#include "measuring/measure.hpp"
#include "performance/sections.hpp"
#include "performance/street_run.hpp"

namespace moat::performance {
namespace {

// One digit: "3e5".
std::string count_text(double value) {
  const int exponent = static_cast<int>(std::floor(std::log10(value)));
  return std::to_string(std::lround(value / std::pow(10.0, exponent))) + "e" + std::to_string(exponent);
}

/// Returns the slope of log y over log x.
double slope(std::vector<double> x, std::vector<double> y) {
  for (auto* values : {&x, &y})
    for (double& value : *values) value = std::log(value);
  return boost::math::statistics::simple_ordinary_least_squares(x, y).second;
}

// The measurements of all runs of one size.
struct Size {
  double degrees_of_freedom = 0.0, peak_bytes = 0.0;
  std::vector<double> per_step, per_iteration, iterations, build_seconds;

  void add(const StreetReport& report) {
    degrees_of_freedom = report.degrees_of_freedom;
    peak_bytes = report.peak_bytes;
    build_seconds.push_back(report.build_seconds);
    for (std::size_t i = 0; i < report.step_seconds.size(); ++i) {
      per_step.push_back(report.step_seconds[i]);
      iterations.push_back(report.step_iterations[i]);
      if (report.step_iterations[i] > 0.0) per_iteration.push_back(report.step_seconds[i] / report.step_iterations[i]);
    }
  }
  [[nodiscard]] double mean_iterations() const {
    return std::accumulate(iterations.begin(), iterations.end(), 0.0) / static_cast<double>(iterations.size());
  }
};

std::vector<Size> sizes_in_turns(const Options& options) {
  constexpr int buildings[] = {167, 1000, 5270, 16667};
  std::vector<Size> sizes(std::size(buildings));
  for (int round = 0; round < (options.quick ? 1 : options.rounds); ++round)
    for (std::size_t i = 0; i < sizes.size(); ++i) sizes[i].add(run_street(buildings[i]));
  return sizes;
}

}  // namespace

void scale(Record& record, const Options& options) {
  record.section("scale");
  Table table{{"DOF", "step [ms]", "iterations of a step", "Newton iteration [ms]", "to build the model [s]",
               "peak memory of the process [MB]"}};
  std::vector<double> n, per_step, per_iteration;
  for (const Size& size : sizes_in_turns(options)) {
    const std::string row = count_text(size.degrees_of_freedom);
    const auto put = [&](const char* column, const char* name, const Spread& value, const char* unit) {
      table.put(row, column, cell(record.add({"street of " + row + " DOF, " + name, value, unit})));
    };
    const Spread step = scaled(spread_of(size.per_step), 1e3), iteration = scaled(spread_of(size.per_iteration), 1e3);
    put("step [ms]", "time per step", step, "ms");
    put("iterations of a step", "iterations of a step, mean", single(size.mean_iterations()), "");
    put("Newton iteration [ms]", "time per step over Newton iterations", iteration, "ms");
    put("to build the model [s]", "time to build the model", spread_of(size.build_seconds), "s");
    put("peak memory of the process [MB]", "peak memory of the process", single(1e-6 * size.peak_bytes), "MB");
    n.push_back(size.degrees_of_freedom);
    per_step.push_back(step.median);
    per_iteration.push_back(iteration.median);
  }
  record.table(table);
  Table targets{{"", "Measured", "Target"}};
  for (const auto& [name, times] : {std::pair{"slope of log time per step over log DOF", per_step},
                                    std::pair{"slope of log time per iteration over log DOF", per_iteration}}) {
    const Figure& figure = record.add({std::string{"street, "} + name, single(slope(n, times)), "", Target{1.05}});
    targets.put(name, "Measured", cell(figure));
    targets.put(name, "Target", text(*figure.target));
  }
  record.table(targets);
  const StreetSetting setting;
  record.note("Fixed steps of 2.5 ms; steps " + std::to_string(setting.steps_before + 1) + " to " +
              std::to_string(setting.steps_before + setting.steps) +
              " are measured, on the wall clock, with the energy ledger attached. The memory is that of a whole "
              "process: code, model with all names, matrix, factors, states.");
}

}  // namespace moat::performance
