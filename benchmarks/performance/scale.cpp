#include "performance/scale.hpp"

#include <algorithm>
#include <cmath>

#include "output/chart.hpp"
#include "performance/measure.hpp"
#include "performance/street_run.hpp"

namespace moat::performance {
namespace {

/// Longer than a base can move in one step: touches are then taken at the end of the step that sees them. Located to
/// 1e-12 m one by one, each of them would end a step of its own, and the number of steps grow with that of buildings.

constexpr int steps_before = 24, steps = 40;

/// Target of the peak memory per degree of freedom of the largest street.
constexpr double largest_bytes = 1500.0;

struct Size {
  double degrees_of_freedom = 0.0;
  std::vector<double> per_step, per_iteration;  // s, of every step
  double bytes_per_degree_of_freedom = 0.0;
};

// One digit: "3e5".
std::string count_text(double value) {
  const int exponent = static_cast<int>(std::floor(std::log10(value)));
  return std::to_string(std::lround(value / std::pow(10.0, exponent))) + "e" + std::to_string(exponent);
}

std::string named(double degrees_of_freedom) { return "street of " + count_text(degrees_of_freedom) + " DOF, "; }

double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
  const auto count = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / count;
    mean_y += std::log(y[i]) / count;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
    xy += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
  }
  return xy / xx;
}

void add_steps(Size& size, const StreetReport& report) {
  size.degrees_of_freedom = report.degrees_of_freedom;
  size.bytes_per_degree_of_freedom = report.peak_bytes / report.degrees_of_freedom;
  for (std::size_t i = 0; i < report.step_seconds.size(); ++i) {
    size.per_step.push_back(report.step_seconds[i]);
    if (report.step_iterations[i] > 0.0)
      size.per_iteration.push_back(report.step_seconds[i] / report.step_iterations[i]);
  }
}

Spread scaled(Spread value, double factor) {
  return {value.median * factor, value.low * factor, value.high * factor, value.count};
}

void show_window(Record& record, const StreetReport& report) {
  const std::string name = named(report.degrees_of_freedom);
  record.add(
      {name + "motion covered by " + std::to_string(steps) + " steps", single(1e3 * report.motion_seconds), "ms"});
  record.add({name + "touches and separations in them", single(report.changes), ""});
  record.add({name + "contacts closed at their end", single(report.contacts_at_end), ""});
  record.add({name + "solves per step", single(report.solves / steps), ""});
  double iterations = 0.0;
  for (const double each : report.step_iterations) iterations += each;
  record.add({name + "Newton iterations per step", single(iterations / steps), ""});
  record.add({name + "factorisations per iteration", single(report.factorisations / iterations), ""});
  record.add({name + "time to build the model", single(report.build_seconds), "s"});
  record.add({name + "time to start the analysis", single(report.start_seconds), "s"});
}

// An iteration and its parts beside the time in which a copy moves as many bytes.
void show_parts(Record& record, const StreetReport& report) {
  const std::string name = named(report.degrees_of_freedom);
  std::vector<double> speeds;
  for (const double each : report.seconds_per_byte) speeds.push_back(1e-9 / each);
  record.add({"memory, copied on one thread, read + written", spread_of(speeds), "GB/s"});
  const auto beside_streaming = [&](const std::vector<double>& taken, double bytes) {
    std::vector<double> streaming;
    for (const double each : report.seconds_per_byte) streaming.push_back(each * bytes);
    return ratio_of(taken, streaming);
  };
  for (const StreetPart& part : report.parts) {
    record.add(
        {name + part.name + ", bytes it must touch per DOF", single(part.bytes / report.degrees_of_freedom), "B"});
    record.add({name + part.name, scaled(spread_of(part.seconds), 1e3), "ms"});
    std::optional<Target> target;
    if (part.name == "iteration") target = Target{8.0};
    record.add(
        {name + part.name + " over streaming its bytes", beside_streaming(part.seconds, part.bytes), "", target});
  }
  std::vector<double> both;
  for (std::size_t i = 0; i < report.parts[0].seconds.size(); ++i)
    both.push_back(report.parts[0].seconds[i] + report.parts[1].seconds[i]);
  record.add({name + "evaluation + assembly over streaming their bytes",
              beside_streaming(both, report.parts[0].bytes + report.parts[1].bytes), "", Target{2.0}});
}

void show_charts(Record& record, const std::vector<Size>& sizes) {
  Series step{.name = "step", .x = {}, .y = {}}, iteration{.name = "Newton iteration", .x = {}, .y = {}};
  Series memory{.name = "whole process", .x = {}, .y = {}};
  for (const Size& size : sizes) {
    for (Series* series : {&step, &iteration, &memory}) series->x.push_back(size.degrees_of_freedom);
    step.y.push_back(1e3 * spread_of(size.per_step).median);
    iteration.y.push_back(1e3 * spread_of(size.per_iteration).median);
    memory.y.push_back(size.bytes_per_degree_of_freedom);
  }
  Series linear{.name = "in proportion", .x = {step.x.front(), step.x.back()}, .y = {}, .style = Series::Style::dashed};
  linear.y = {step.y.back() * step.x.front() / step.x.back(), step.y.back()};
  const Series target{.name = "target at 1e6",
                      .x = {memory.x.front(), memory.x.back()},
                      .y = {largest_bytes, largest_bytes},
                      .style = Series::Style::dashed};
  record.chart("scale.svg",
               {{.title = "Time on one thread",
                 .x_label = "degrees of freedom",
                 .y_label = "time [ms]",
                 .series = {step, iteration, linear},
                 .logarithmic_x = true,
                 .logarithmic_y = true},
                {.title = "Memory",
                 .x_label = "degrees of freedom",
                 .y_label = "peak per degree of freedom [B]",
                 .series = {memory, target},
                 .logarithmic_x = true,
                 .logarithmic_y = true}},
               1000, 360, 2);
}

void grow(Record& record, const Options& options) {
  std::vector<int> buildings{167, 527, 1667, 5270, 16667, 52705};
  if (!options.quick) buildings.push_back(166667);
  std::vector<Size> sizes(buildings.size());
  StreetReport largest;
  // Small streets take turns, three times; the large ones run once: they take long enough.
  constexpr int passes = 3, repeated_up_to = 20000;
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t i = 0; i < buildings.size(); ++i) {
      if (pass > 0 && buildings[i] > repeated_up_to) continue;
      const bool last = i + 1 == buildings.size();
      const StreetReport report = run_street({.buildings = buildings[i],
                                              .location_tolerance = street_location_tolerance,
                                              .steps_before = steps_before,
                                              .steps = steps,
                                              .parts = last});
      add_steps(sizes[i], report);
      if (last) largest = report;
    }
  }
  std::vector<double> n, per_step, per_iteration;
  for (const Size& size : sizes) {
    const std::string name = named(size.degrees_of_freedom);
    record.add({name + "time per step", scaled(spread_of(size.per_step), 1e3), "ms"});
    record.add({name + "time per step over Newton iterations", scaled(spread_of(size.per_iteration), 1e3), "ms"});
    record.add({name + "peak memory of the process per DOF", single(size.bytes_per_degree_of_freedom), "B",
                &size == &sizes.back() ? std::optional{Target{largest_bytes}} : std::nullopt});
    n.push_back(size.degrees_of_freedom);
    per_step.push_back(spread_of(size.per_step).median);
    per_iteration.push_back(spread_of(size.per_iteration).median);
  }
  record.add({"street, slope of log time per step over log DOF", single(slope(n, per_step)), "", Target{1.05}});
  record.add(
      {"street, slope of log time per iteration over log DOF", single(slope(n, per_iteration)), "", Target{1.05}});
  // Small streets fit into a cache that is faster than memory; what follows does not.
  const std::size_t beyond_caches = 4;
  if (n.size() > beyond_caches + 1)
    record.add({"street, slope of log time per step over log DOF, from 1e5 DOF on",
                single(slope({n.begin() + beyond_caches, n.end()}, {per_step.begin() + beyond_caches, per_step.end()})),
                ""});
  show_window(record, largest);
  show_parts(record, largest);
  show_charts(record, sizes);
}

// What locating every touch does to a street: the same number of steps covers less and less motion.
void show_located(Record& record) {
  for (const int buildings : {167, 1667, 16667}) {
    const StreetReport report = run_street({.buildings = buildings, .steps_before = steps_before, .steps = steps});
    const std::string name = named(report.degrees_of_freedom) + "touches located to 1e-12 m, ";
    record.add({name + "motion covered per step", single(1e6 * report.motion_seconds / steps), "us"});
    Size size;
    add_steps(size, report);
    record.add({name + "solves per step", single(report.solves / steps), ""});
    record.add({name + "time per step over Newton iterations", scaled(spread_of(size.per_iteration), 1e3), "ms"});
  }
}

}  // namespace

void scale(Record& record, const Options& options) {
  record.section("scale", "Scale: a street of isolated buildings that pound each other");
  record.note("Fixed steps of 2.5 ms from the start of a pulse in which contacts begin and end everywhere; steps " +
              std::to_string(steps_before + 1) + " to " + std::to_string(steps_before + steps) +
              " are measured, on the wall clock, with the energy ledger attached. Each street runs in a process of its "
              "own, whose whole peak counts as memory: code, model with all names, matrix, factors, states.");
  grow(record, options);
  show_located(record);
}

}  // namespace moat::performance
