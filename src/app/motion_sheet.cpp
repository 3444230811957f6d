#include "app/motion_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/text/number_format.hpp"
#include "base/units.hpp"

namespace moat {
namespace {

using Json = nlohmann::ordered_json;

constexpr double first_period = 0.02, last_period = 10.0;  // s
constexpr int period_count = 120;
// Periods of the table on the terminal, s.
constexpr std::array shown_periods{0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 7.0, 10.0};

std::string line(const std::string& name, const std::string& value, const std::string& remark = "") {
  constexpr std::size_t name_width = 22, value_width = 14;
  const auto padded = [](const std::string& text, std::size_t width) {
    return text + std::string(width - std::min(width, text.size()), ' ');
  };
  return "  " + padded(name, name_width) + (remark.empty() ? value : padded(value, value_width) + remark) + "\n";
}

std::string measures(const MotionSheet& sheet) {
  const GroundMotion& motion = sheet.motion;
  const double pga = motion.peak_acceleration().si(), pgv = motion.peak_velocity().si();
  const auto number = [](double value) { return to_significant(value, 4); };
  const auto seconds = [](double value) { return to_fixed(value, 2) + " s"; };
  const MotionInterval& strong = sheet.significant_duration;
  return motion.name() + "\n" + line("PGA", number(pga / standard_gravity) + " g", number(pga) + " m/s^2") +
         line("PGV", number(100.0 * pgv) + " cm/s") +
         line("PGD", number(100.0 * motion.peak_displacement().si()) + " cm",
              "integrated without baseline correction") +
         line("PGV/PGA", number(pgv / pga) + " s") + line("Arias intensity", number(sheet.arias_intensity) + " m/s") +
         line("significant duration", seconds(strong.length()),
              "5 to 95 % of the Arias intensity, from " + seconds(strong.start) + " to " + seconds(strong.end)) +
         line("pulse period", seconds(sheet.pulse_period),
              "largest pseudo-velocity with 5 % damping (Alavi & Krawinkler 2001)") +
         line("samples", std::to_string(motion.samples().size()),
              "every " + number(motion.time_step()) + " s, " + number(motion.duration()) + " s in all") +
         "\n";
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

}  // namespace

MotionSheet sheet_of(const GroundMotion& motion, double damping_ratio) {
  const Time first{std::max(first_period, 0.01 * motion.time_step())};
  return {
      .motion = motion,
      .arias_intensity = arias_intensity(motion).si(),
      .significant_duration = significant_duration(motion),
      .pulse_period = pulse_period(motion).si(),
      .spectrum = response_spectrum(
          motion, spaced_periods(first, Time{std::max(last_period, 2.0 * first.si())}, period_count), damping_ratio)};
}

std::string text_of(const std::vector<MotionSheet>& sheets) {
  std::string text;
  for (const MotionSheet& sheet : sheets) text += measures(sheet);
  return text + table_of(sheets);
}

std::string json_of(const std::vector<MotionSheet>& sheets) {
  Json json = Json::array();
  for (const MotionSheet& sheet : sheets) {
    const GroundMotion& motion = sheet.motion;
    json.push_back({{"name", motion.name()},
                    {"file", motion.file().path},
                    {"sha256", motion.file().sha256},
                    {"time_step", motion.time_step()},
                    {"duration", motion.duration()},
                    {"samples", motion.samples().size()},
                    {"peak_acceleration", motion.peak_acceleration().si()},
                    {"peak_velocity", motion.peak_velocity().si()},
                    {"peak_displacement", motion.peak_displacement().si()},
                    {"arias_intensity", sheet.arias_intensity},
                    {"significant_duration",
                     {{"from", 0.05},
                      {"to", 0.95},
                      {"start", sheet.significant_duration.start},
                      {"end", sheet.significant_duration.end},
                      {"length", sheet.significant_duration.length()}}},
                    {"pulse_period", sheet.pulse_period},
                    {"units",
                     {{"time_step", "s"},
                      {"duration", "s"},
                      {"peak_acceleration", "m/s^2"},
                      {"peak_velocity", "m/s"},
                      {"peak_displacement", "m"},
                      {"arias_intensity", "m/s"},
                      {"significant_duration", "s"},
                      {"pulse_period", "s"},
                      {"period", "s"},
                      {"pseudo_acceleration", "m/s^2"},
                      {"displacement", "m"}}},
                    {"spectrum",
                     {{"damping_ratio", sheet.spectrum.damping_ratio},
                      {"period", sheet.spectrum.period},
                      {"pseudo_acceleration", sheet.spectrum.pseudo_acceleration},
                      {"displacement", sheet.spectrum.displacement}}}});
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

}  // namespace moat
