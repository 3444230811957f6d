#include <boost/math/statistics/linear_regression.hpp>
#include <cmath>
#include <numeric>

#include "measuring/measure.hpp"
#include "measuring/street.hpp"
#include "performance/sections.hpp"
#include "performance/street_run.hpp"

namespace moat::performance {
namespace {

constexpr Target largest_bytes{1500.0};

struct Size {
  double degrees_of_freedom = 0.0;
  std::vector<double> per_step, per_iteration, iterations;  // s, of every step; their number
  double bytes_per_degree_of_freedom = 0.0;
};

// One digit: "3e5".
std::string count_text(double value) {
  const int exponent = static_cast<int>(std::floor(std::log10(value)));
  return std::to_string(std::lround(value / std::pow(10.0, exponent))) + "e" + std::to_string(exponent);
}

std::string named(double degrees_of_freedom) { return "street of " + count_text(degrees_of_freedom) + " DOF, "; }

/// Of log y over log x.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
  const auto log = [](std::vector<double> values) {
    for (double& value : values) value = std::log(value);
    return values;
  };
  return boost::math::statistics::simple_ordinary_least_squares(log(x), log(y)).second;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void add_steps(Size& size, const StreetReport& report) {
  size.degrees_of_freedom = report.degrees_of_freedom;
  size.bytes_per_degree_of_freedom = report.peak_bytes / report.degrees_of_freedom;
  for (std::size_t i = 0; i < report.step_seconds.size(); ++i) {
    size.per_step.push_back(report.step_seconds[i]);
    size.iterations.push_back(report.step_iterations[i]);
    if (report.step_iterations[i] > 0.0)
      size.per_iteration.push_back(report.step_seconds[i] / report.step_iterations[i]);
  }
}

class Report {
 public:
  explicit Report(Record& record) : record_{&record} {}

  void run(bool quick) {
    grow(quick);
    show_sizes();
    show_parts();
    compare_events(quick);
    record_->table(sizes_table_);
    record_->table(parts_table_);
    record_->table(targets_);
    record_->table(events_table_);
  }

 private:
  const Figure& judge(const std::string& name, const Spread& value, Target target, const std::string& unit = {}) {
    const Figure& figure = record_->add({name, value, unit, target});
    targets_.put(name + (unit.empty() ? "" : " [" + unit + "]"), "Measured", cell(figure));
    targets_.put(name + (unit.empty() ? "" : " [" + unit + "]"), "Target", text(target));
    return figure;
  }

  // Small streets take turns, three times; the large ones run once: they take long enough.
  void grow(bool quick) {
    std::vector<int> buildings{167, 527, 1667, 5270, 16667, 52705};
    if (!quick) buildings.push_back(166667);
    sizes_.resize(buildings.size());
    constexpr int passes = 3, repeated_up_to = 20000;
    for (int pass = 0; pass < passes; ++pass)
      for (std::size_t i = 0; i < buildings.size(); ++i) {
        if (pass > 0 && buildings[i] > repeated_up_to) continue;
        const bool last = i + 1 == buildings.size();
        const StreetReport report = run_street({.buildings = buildings[i], .parts = last});
        add_steps(sizes_[i], report);
        if (last) largest_ = report;
      }
    time_builds({.buildings = buildings.back(), .steps_before = 0, .steps = 0}, quick ? 1 : 5);
  }

  // After one that warms up the memory of the machine.
  void time_builds(const StreetSetting& largest, int rounds) {
    for (int round = -1; round < rounds; ++round) {
      const double seconds = run_street(largest).build_seconds;
      if (round >= 0) build_seconds_.push_back(seconds);
    }
  }

  void show_sizes() {
    std::vector<double> n, per_step, per_iteration;
    for (const Size& size : sizes_) {
      const std::string name = named(size.degrees_of_freedom), row = count_text(size.degrees_of_freedom);
      const Spread step = scaled(spread_of(size.per_step), 1e3), iteration = scaled(spread_of(size.per_iteration), 1e3);
      const std::string memory = name + "peak memory of the process per DOF";
      const Spread bytes = single(size.bytes_per_degree_of_freedom);
      sizes_table_.put(row, "step [ms]", cell(record_->add({name + "time per step", step, "ms"})));
      sizes_table_.put(row, "Newton iteration [ms]",
                       cell(record_->add({name + "time per step over Newton iterations", iteration, "ms"})));
      sizes_table_.put(row, "peak memory of the process per DOF [B]",
                       cell(&size == &sizes_.back() ? judge(memory, bytes, largest_bytes, "B")
                                                    : record_->add({memory, bytes, "B"})));
      sizes_table_.put(row, "iterations of a step",
                       cell(record_->add({name + "iterations of a step, mean", single(mean(size.iterations))})));
      n.push_back(size.degrees_of_freedom);
      per_step.push_back(step.median);
      per_iteration.push_back(iteration.median);
    }
    const std::string largest = named(largest_.degrees_of_freedom);
    const std::string until_built = largest + "peak memory until the model is built, per DOF";
    const double model_bytes = largest_.model_bytes / largest_.degrees_of_freedom;
    targets_.put(until_built + " [B]", "Measured", cell(record_->add({until_built, single(model_bytes), "B"})));
    judge(largest + "time to build the model", spread_of(build_seconds_), Target{2.0}, "s");
    judge("street, slope of log time per step over log DOF", single(slope(n, per_step)), Target{1.05});
    judge("street, slope of log time per iteration over log DOF", single(slope(n, per_iteration)), Target{1.05});
  }

  // An iteration and its parts beside the time in which a copy moves as many bytes.
  void show_parts() {
    const std::string name = named(largest_.degrees_of_freedom);
    std::vector<double> speeds;
    for (const double each : largest_.seconds_per_byte) speeds.push_back(1e-9 / each);
    record_->add({"memory, copied on one thread, read + written", spread_of(speeds), "GB/s"});
    const auto beside_streaming = [&](const std::vector<double>& taken, double bytes) {
      std::vector<double> streaming;
      for (const double each : largest_.seconds_per_byte) streaming.push_back(each * bytes);
      return ratio_of(taken, streaming);
    };
    for (const StreetPart& part : largest_.parts) {
      const double bytes = part.bytes / largest_.degrees_of_freedom;
      const std::string over = name + part.name + " over streaming its bytes";
      const Spread ratio = beside_streaming(part.seconds, part.bytes);
      record_->add({name + part.name + ", bytes it must touch per DOF", single(bytes), "B"});
      parts_table_.put(part.name, "bytes it must touch per DOF", short_text(bytes));
      parts_table_.put(part.name, "time [ms]",
                       cell(record_->add({name + part.name, scaled(spread_of(part.seconds), 1e3), "ms"})));
      parts_table_.put(part.name, "time over streaming the bytes",
                       cell(part.name == "iteration" ? judge(over, ratio, Target{2.5}) : record_->add({over, ratio})));
    }
    const StreetPart &evaluation = largest_.parts[0], &assembly = largest_.parts[1];
    std::vector<double> both;
    for (std::size_t i = 0; i < evaluation.seconds.size(); ++i)
      both.push_back(evaluation.seconds[i] + assembly.seconds[i]);
    judge(name + "evaluation + assembly over streaming their bytes",
          beside_streaming(both, evaluation.bytes + assembly.bytes), Target{2.0});
  }

  // Adapted steps that go on over changes of regime, beside steps that end at each of them, in turns.
  void compare_events(bool quick) {
    constexpr int buildings = 1000;
    const Time end = quick ? 0.1 * units::s : 1.0 * units::s;
    const auto seconds_of = [&](EventTreatment events, long& steps) {
      Model model = street(buildings);
      Transient transient{model, street_motion(), {.end = end, .events = events}};
      const double start = seconds();
      transient.run();
      steps = transient.statistics().accepted_steps;
      return (seconds() - start) / end.si();
    };
    std::vector<double> inside, located;
    long steps_inside = 0, steps_located = 0;
    for (int round = 0; round < 3; ++round) {
      located.push_back(seconds_of(EventTreatment::located, steps_located));
      inside.push_back(seconds_of(EventTreatment::automatic, steps_inside));
    }
    const std::string name = named(buildings * degrees_of_freedom_per_building) + "adapted steps, ";
    const auto put = [&](const std::string& row, const std::vector<double>& taken, long steps) {
      events_table_.put(row, "CPU seconds per second of motion",
                        cell(record_->add({name + row + ", per second of motion", spread_of(taken), "s"})));
      events_table_.put(row, "steps", std::to_string(steps));
    };
    put("default", inside, steps_inside);
    put("every event located", located, steps_located);
    events_table_.put("located / default", "CPU seconds per second of motion",
                      cell(record_->add({name + "located / default", ratio_of(located, inside)})));
  }

  Record* record_;
  std::vector<Size> sizes_;
  StreetReport largest_;
  std::vector<double> build_seconds_;  // of the largest
  Table sizes_table_{
      {"DOF", "step [ms]", "iterations of a step", "Newton iteration [ms]", "peak memory of the process per DOF [B]"}};
  Table parts_table_{{"Largest street", "bytes it must touch per DOF", "time [ms]", "time over streaming the bytes"}};
  Table targets_{{"", "Measured", "Target"}};
  Table events_table_{{"Street of 6,000 DOF", "CPU seconds per second of motion", "steps"}};
};

}  // namespace

void scale(Record& record, const Options& options) {
  record.section("scale");
  Report{record}.run(options.quick);
  const StreetSetting setting;
  record.note("Fixed steps of 2.5 ms; steps " + std::to_string(setting.steps_before + 1) + " to " +
              std::to_string(setting.steps_before + setting.steps) +
              " are measured, on the wall clock, with the energy ledger attached. The memory is that of a whole "
              "process: code, model with all names, matrix, factors, states.");
}

}  // namespace moat::performance
