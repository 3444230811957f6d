// How the error of the peaks falls with the number of steps, for fixed and adaptive stepping.
//
// The five-storey building of Zhao, Liu & Li (2017) in its moat, Hertz-damp law, under three recorded motions at 0.4 g
// and under the embedded pulse. The error is the largest relative error of base and top displacement, base and top
// absolute acceleration, impact force and first storey shear: for the records against the converged peaks of an
// independent program (benchmarks/paper/reference_peaks.csv), for the pulse against moat's own with a tolerance of
// 1e-7. Then streets of buildings and random models. Called by ./moat bench accuracy.
#include <moat.hpp>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "app/command_line.hpp"
#include "base/text/number_format.hpp"
#include "documentation_section.hpp"
#include "measuring/five_peaks.hpp"
#include "output/charts/chart.hpp"
#include "paper/paper_building.hpp"
#include "paper/printed_table.hpp"
#include "paper/records.hpp"
#include "random_models.hpp"
#include "streets.hpp"

namespace {

using namespace moat;
using namespace moat::units;

using Peaks = std::array<double, 6>;

struct Motion {
  std::string name;
  GroundMotion motion;
  Peaks reference;
};

/// One run: its cost and its error.
struct Point {
  std::string setting;
  double steps = 0.0;
  double error = 0.0;
  double energy_error = 0.0;
};

struct Curves {
  std::vector<Point> fixed, adaptive;
};

CaseResult run(const GroundMotion& motion, const TransientOptions& options) {
  Model model;
  const auto building = paper::add(model, paper::PaperBuilding{});
  add(model, Moat{.around = building.base,
                  .clearance = paper::paper_gap,
                  .law = HertzDamp{.stiffness = paper::hertz_impact_stiffness, .restitution = paper::restitution}});
  return run_case(model, motion, {.transient = options});
}

Peaks peaks_of(const CaseResult& result) {
  const auto peak = [&](const char* quantity, const char* where) {
    return performance::peak_of(result, quantity, where);
  };
  return {peak("displacement", "base"),          peak("displacement", "floor 5"),
          peak("absolute_acceleration", "base"), peak("absolute_acceleration", "floor 5"),
          peak("impact_force", "moat"),          peak("storey_shear", "storey 1")};
}

/// Returns the peaks of the reference; there is none for KBU000.
std::optional<Peaks> reference_of(const std::string& record) {
  for (const paper::PrintedRow& row : paper::printed_table("reference_peaks.csv")) {
    if (row.at("record") != record || row.at("case") != "hertz_damp") continue;
    const auto number = [&](const char* column, double unit) { return unit * paper::number(row, column); };
    return Peaks{number("base_displacement_cm", 0.01),  number("top_displacement_cm", 0.01),
                 number("base_acceleration_m_s2", 1.0), number("top_acceleration_m_s2", 1.0),
                 number("impact_force_kN", 1e3),        number("first_storey_shear_kN", 1e3)};
  }
  return std::nullopt;
}

std::vector<Motion> motions() {
  std::vector<Motion> list;
  const GroundMotion pulse = near_fault_pulse().scaled_to_pga(0.4 * g);
  list.push_back({"pulse", pulse, peaks_of(run(pulse, {.tolerance = 1e-7, .steps_per_contact = 512}))});
  if (const std::string missing = paper::missing_records(); !missing.empty()) {
    std::printf("Skipped: recorded motions. %s\n", missing.c_str());
    return list;
  }
  for (const paper::PaperRecord& record : paper::paper_records)
    if (const auto reference = reference_of(std::filesystem::path{record.file}.stem()))
      list.push_back({record.label, paper::read_unscaled(record).scaled_to_pga(paper::paper_pga), *reference});
  return list;
}

Point measure(const Motion& motion, const std::string& setting, const TransientOptions& options) {
  const CaseResult result = run(motion.motion, options);
  return {setting, static_cast<double>(result.solver.accepted_steps),
          performance::largest_error(peaks_of(result), motion.reference),
          std::abs(result.energy.integration_error) / result.energy.largest_input};
}

Curves measure(const Motion& motion) {
  Curves curves;
  for (const int divisions : {1, 2, 4, 8, 16, 32}) {
    const double step = motion.motion.time_step() / divisions;
    curves.fixed.push_back(measure(motion, to_text(1e3 * step) + " ms", {.step = step * s}));
  }
  const TransientOptions defaults;
  for (const double tolerance : {3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5}) {
    // Contacts are divided in step with the tolerance: the error of both falls with the square of the step.
    const double finer = std::sqrt(defaults.tolerance / tolerance);
    const int per_contact = std::max(8, static_cast<int>(defaults.steps_per_contact * finer));
    curves.adaptive.push_back(measure(motion,
                                      to_text(tolerance) + (tolerance == defaults.tolerance ? " (default)" : ""),
                                      {.tolerance = tolerance, .steps_per_contact = per_contact}));
  }
  return curves;
}

Series series_of(const std::string& name, const std::vector<Point>& points) {
  Series series{.name = name, .x = {}, .y = {}, .style = Series::Style::line};
  for (const Point& point : points) {
    series.x.push_back(point.steps);
    series.y.push_back(100.0 * point.error);
  }
  return series;
}

std::string table_of(const Motion& motion, const Curves& curves) {
  std::string text = "**" + motion.name +
                     "**\n\n| fixed step | steps | error of peaks, % | energy error, % | tolerance "
                     "| steps | error of peaks, % | energy error, % |\n|---|---|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < curves.fixed.size(); ++i) {
    for (const Point* point : {&curves.fixed[i], &curves.adaptive[i]})
      text += "| " + point->setting + " | " + std::to_string(static_cast<long>(point->steps)) + " | " +
              to_fixed(100.0 * point->error, 4) + " | " + to_fixed(100.0 * point->energy_error, 4) + " ";
    text += "|\n";
  }
  return text + "\n";
}

void run_all(const std::filesystem::path& folder, const std::filesystem::path& documentation) {
  const std::vector<Motion> list = motions();
  if (!documentation.empty() && list.size() < 4) throw InputError{"--write-docs needs the recorded motions."};
  std::filesystem::create_directories(folder);
  std::vector<Chart> charts;
  std::string tables;
  for (const Motion& motion : list) {
    const Curves curves = measure(motion);
    charts.push_back({.title = motion.name,
                      .x_label = "steps",
                      .y_label = "largest error of the peaks [%]",
                      .series = {series_of("fixed step", curves.fixed), series_of("adaptive step", curves.adaptive)},
                      .logarithmic_x = true,
                      .logarithmic_y = true});
    tables += table_of(motion, curves);
  }
  write_svg(charts, folder / "accuracy.svg", 1000, 340);
  std::printf("%s\nFigure: %s\n", tables.c_str(), (folder / "accuracy.svg").c_str());
  if (!documentation.empty()) {
    replace_section(documentation / "models.md", "accuracy", tables);
    std::filesystem::copy_file(folder / "accuracy.svg", documentation.parent_path() / "images/accuracy.svg",
                               std::filesystem::copy_options::overwrite_existing);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Error of the peaks against the number of steps, fixed and adaptive", "moat bench accuracy"};
  std::string folder = "results/accuracy";
  bool write_docs = false;
  app.add_option("--out", folder, "folder for the figure")->capture_default_str();
  app.add_flag("--write-docs", write_docs, "also bring docs/verification and its figure up to date");
  RandomModelsOptions random;
  bool only_random = false;
  app.add_option("--models", random.models, "number of random models, 0 for none")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  app.add_option("--seed", random.seed, "of the first random model; the others follow it")->capture_default_str();
  app.add_option("--threads", random.threads, "for the random models")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--tolerance", random.tolerance, "for the random models, but for the tight setting")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--csv", random.csv, "file for a row per random model and setting");
  app.add_flag("--only-random", only_random, "random models alone");
  return run_command(app, "moat bench accuracy", argc, argv, [&] {
    const std::filesystem::path documentation = write_docs ? MOAT_VERIFICATION : "";
    if (!only_random) {
      run_all(folder, documentation);
      const std::string table = run_streets();
      std::printf("%s\n", table.c_str());
      if (write_docs) replace_section(documentation / "random_models.md", "streets", table);
    }
    if (random.models > 0) {
      const std::string tables = run_random_models(random);
      std::printf("%s\n", tables.c_str());
      if (write_docs) replace_section(documentation / "random_models.md", "random models", tables);
    }
    return 0;
  });
}
