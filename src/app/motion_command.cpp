// The program behind `moat motion`: the numbers of accelerograms.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "base/error.hpp"
#include "base/parse_quantity.hpp"
#include "base/text/number_format.hpp"
#include "base/text/terminal.hpp"
#include "base/units.hpp"
#include "motions/motion_measures.hpp"
#include "motions/readers/record_channel.hpp"
#include "motions/response_spectrum.hpp"
#include "output/charts/chart.hpp"
#include "output/files/csv_writer.hpp"

namespace moat {
namespace {

using Json = nlohmann::ordered_json;

constexpr double first_period = 0.02, last_period = 10.0;  // s
constexpr int period_count = 120;
// Periods of the table on the terminal, s.
constexpr std::array shown_periods{0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 7.0, 10.0};

/// A motion with its spectrum.
struct MotionSheet {
  GroundMotion motion;
  ResponseSpectrum spectrum{};
};

// Periods of the spectrum from 0.02 to 10 s.
MotionSheet sheet_of(const GroundMotion& motion, double damping_ratio) {
  const Time first{std::max(first_period, 0.01 * motion.time_step())};
  return {motion,
          response_spectrum(motion, spaced_periods(first, Time{std::max(last_period, 2.0 * first.si())}, period_count),
                            damping_ratio)};
}

/// A row of the text, and a member of the JSON.
struct Measure {
  const char *key, *name;
  Json value;  ///< in `unit`
  const char* unit;
  std::string text, remark{};
};

std::vector<Measure> measures_of(const GroundMotion& motion) {
  const double pga = motion.peak_acceleration().si(), pgv = motion.peak_velocity().si(),
               pgd = motion.peak_displacement().si(), intensity = arias_intensity(motion).si(),
               period_of_pulse = pulse_period(motion).si();
  const auto number = [](double value) { return to_significant(value, 4); };
  const auto seconds = [](double value) { return to_fixed(value, 2) + " s"; };
  const MotionInterval strong = significant_duration(motion);
  return {
      {"peak_acceleration", "PGA", pga, "m/s^2", number(pga / standard_gravity) + " g", number(pga) + " m/s^2"},
      {"peak_velocity", "PGV", pgv, "m/s", number(100.0 * pgv) + " cm/s"},
      {"peak_displacement", "PGD", pgd, "m", number(100.0 * pgd) + " cm", "integrated without baseline correction"},
      {"pgv_over_pga", "PGV/PGA", pgv / pga, "s", number(pgv / pga) + " s"},
      {"arias_intensity", "Arias intensity", intensity, "m/s", number(intensity) + " m/s"},
      {"significant_duration", "significant duration",
       Json{{"from", 0.05}, {"to", 0.95}, {"start", strong.start}, {"end", strong.end}, {"length", strong.length()}},
       "s", seconds(strong.length()),
       "5 to 95 % of the Arias intensity, from " + seconds(strong.start) + " to " + seconds(strong.end)},
      {"pulse_period", "pulse period", period_of_pulse, "s", seconds(period_of_pulse),
       "largest pseudo-velocity with 5 % damping (Alavi & Krawinkler 2001)"},
      {"samples", "samples", motion.samples().size(), "1", std::to_string(motion.samples().size()),
       "every " + number(motion.time_step()) + " s, " + number(motion.duration()) + " s in all"}};
}

std::vector<Time> periods_of_table(const std::vector<MotionSheet>& sheets) {
  double shortest = 0.0;  // that a spectrum allows
  for (const MotionSheet& sheet : sheets) shortest = std::max(shortest, 0.01 * sheet.motion.time_step());
  std::vector<Time> periods;
  for (const double period : shown_periods)
    if (period == 0.0 || period >= shortest) periods.emplace_back(period);
  return periods;
}

std::string table_of(const std::vector<MotionSheet>& sheets) {
  const double damping = sheets.front().spectrum.damping_ratio;
  std::string text = "pseudo-acceleration [g] with " + to_significant(100.0 * damping, 4) + " % damping\n  period [s]";
  const std::vector<Time> periods = periods_of_table(sheets);
  std::vector<std::vector<std::string>> columns;
  for (const MotionSheet& sheet : sheets) {
    const std::string heading = sheet.motion.name();
    std::vector<std::string> column{heading};
    for (const double value : response_spectrum(sheet.motion, periods, damping).pseudo_acceleration)
      column.push_back(to_fixed(value / standard_gravity, 4));
    columns.push_back(std::move(column));
  }
  for (std::size_t row = 0; row <= periods.size(); ++row) {
    if (row > 0) {
      const std::string period = to_fixed(periods[row - 1].si(), 2);
      text += "  " + std::string(10 - period.size(), ' ') + period;
    }
    for (const std::vector<std::string>& column : columns) {
      const std::size_t width = std::max<std::size_t>(8, column.front().size());
      text += "  " + std::string(width - column[row].size(), ' ') + column[row];
    }
    text += "\n";
  }
  return text;
}

// The measures of every motion, and one table of pseudo-accelerations.
std::string text_of(const std::vector<MotionSheet>& sheets) {
  constexpr std::size_t name_width = 22, value_width = 14;
  const auto padded = [](const std::string& text, std::size_t width) {
    return text + std::string(width - std::min(width, text.size()), ' ');
  };
  std::string text;
  for (const MotionSheet& sheet : sheets) {
    text += sheet.motion.name() + "\n";
    for (const Measure& each : measures_of(sheet.motion))
      text += "  " + padded(each.name, name_width) +
              (each.remark.empty() ? each.text : padded(each.text, value_width) + each.remark) + "\n";
    text += "\n";
  }
  return text + table_of(sheets);
}

// All numbers in SI units, and all periods.
std::string json_of(const std::vector<MotionSheet>& sheets) {
  Json json = Json::array();
  for (const MotionSheet& sheet : sheets) {
    const GroundMotion& motion = sheet.motion;
    Json entry{{"name", motion.name()},
               {"file", motion.file().path},
               {"sha256", motion.file().sha256},
               {"time_step", motion.time_step()},
               {"duration", motion.duration()}};
    Json units{{"time_step", "s"}, {"duration", "s"}};
    for (const Measure& each : measures_of(sheet.motion)) {
      entry[each.key] = each.value;
      units[each.key] = each.unit;
    }
    units.update({{"period", "s"}, {"pseudo_acceleration", "m/s^2"}, {"displacement", "m"}});
    entry["units"] = std::move(units);
    entry["spectrum"] = {{"damping_ratio", sheet.spectrum.damping_ratio},
                         {"period", sheet.spectrum.period},
                         {"pseudo_acceleration", sheet.spectrum.pseudo_acceleration},
                         {"displacement", sheet.spectrum.displacement}};
    json.push_back(std::move(entry));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Chart spectrum_chart(const std::vector<MotionSheet>& sheets) {
  const std::string damping = to_significant(100.0 * sheets.front().spectrum.damping_ratio, 4);
  Chart chart{.title = "Pseudo-acceleration, " + damping + " % damping",
              .x_label = "period [s]",
              .y_label = "pseudo-acceleration [g]",
              .series = {},
              .logarithmic_x = true,
              .y_from_zero = true};
  for (const MotionSheet& sheet : sheets) {
    Series series{.name = sheet.motion.name(), .x = sheet.spectrum.period, .y = sheet.spectrum.pseudo_acceleration};
    for (double& value : series.y) value /= standard_gravity;
    chart.series.push_back(std::move(series));
  }
  return chart;
}

Table spectrum_table(const std::vector<MotionSheet>& sheets) {
  Table table;
  for (const MotionSheet& sheet : sheets) {
    // Motions whose samples stand far apart have periods of their own.
    if (table.columns.empty() || sheet.spectrum.period != sheets.front().spectrum.period)
      table.columns.push_back({"period", table.columns.empty() ? "" : sheet.motion.name(), "s", sheet.spectrum.period});
    table.columns.push_back({"pseudo_acceleration", sheet.motion.name(), "m/s^2", sheet.spectrum.pseudo_acceleration});
  }
  return table;
}

struct Options {
  std::vector<std::string> files;
  std::string unit, step, columns, folder;
  double damping = 0.05;
  bool json = false;
};

/// All channels in a file.
std::vector<RecordChannel> read(const std::string& file, const Options& options) {
  TextColumns text{.columns = options.columns};
  const std::optional<double> known = acceleration_unit(options.unit);
  if (!options.unit.empty())
    text.unit = known ? Acceleration{*known} : parse<Acceleration>("1 " + options.unit, "--unit");
  if (!options.step.empty()) text.step = parse<Time>(options.step, "--step");
  try {
    std::vector<RecordChannel> channels = read_channels(file, text);
    check_text(channels, text);
    return channels;
  } catch (const MissingUnit& error) {
    throw InputError{error.problem() + " Give the unit: --unit g, or --unit cm/s^2."};
  }
}

void show(const Options& options) {
  std::vector<MotionSheet> sheets;
  for (const std::string& file : options.files)
    for (const RecordChannel& channel : read(file, options))
      sheets.push_back(sheet_of(motion_of(channel), options.damping));
  print_text(std::cout, options.json ? json_of(sheets) : text_of(sheets));
  if (options.folder.empty()) return;
  const std::filesystem::path folder{options.folder};
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError{folder.string() + ": cannot be created (" + error.message() + ")."};
  write_svg(spectrum_chart(sheets), folder / "spectrum.svg");
  write_csv(spectrum_table(sheets), folder / "spectrum.csv");
  print_text(std::cerr,
             "moat: wrote " + (folder / "spectrum.svg").string() + " and " + (folder / "spectrum.csv").string() + "\n");
}

}  // namespace
}  // namespace moat

int main(int argc, char** argv) {
  using namespace moat;
  CLI::App app{"Shows peaks, intensity, duration, pulse period and spectrum of accelerograms", "moat motion"};
  Options options;
  app.add_option("FILE", options.files, motion_formats())->required();
  // The long names are those of scripts, and of the messages of the readers.
  app.add_option("--unit,--record-unit", options.unit, "unit of plain text: g, gal, cm/s^2 ...");
  app.add_option("--step,--record-step", options.step, "time step of plain text without times: 0.01 s");
  app.add_option("--columns,--record-columns", options.columns, "columns of plain text: time,x or x,y,z or series ...");
  app.add_option("--damping", options.damping, "damping ratio of the spectrum")->capture_default_str();
  app.add_option("--out", options.folder, "folder for spectrum.svg and spectrum.csv");
  app.add_flag("--json", options.json, "print JSON, all numbers in SI units");
  return run_command(app, "moat motion", argc, argv, [&] {
    show(options);
    return 0;
  });
}
