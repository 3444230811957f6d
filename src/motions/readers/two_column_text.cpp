#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "base/text/text_file.hpp"
#include "motions/readers/record_formats.hpp"

namespace moat {
namespace {

constexpr double spacing_tolerance = 1e-4;

std::string_view without_comment(std::string_view line) { return trimmed(line.substr(0, line.find_first_of("#%"))); }

/// The fields of a line. Blanks around a comma or semicolon belong to it; two commas enclose an empty field.
std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t end = line.find_first_of(" \t,;");
    fields.push_back(line.substr(0, end));
    if (end == std::string_view::npos) return fields;
    line = trimmed(line.substr(end));
    if (line.starts_with(',') || line.starts_with(';')) line = trimmed(line.substr(1));
  }
}

bool is_number(std::string_view field) { return parse_number(field).problem == nullptr; }

bool is_nan_or_infinity(std::string_view field) {
  std::string word = upper_case(field);
  if (word.starts_with('-') || word.starts_with('+')) word.erase(0, 1);
  constexpr std::array<std::string_view, 3> values{"NAN", "INF", "INFINITY"};
  return std::find(values.begin(), values.end(), word) != values.end();
}

/// Words only: a number among them, or a value such as NaN, means damaged data rather than a heading.
bool is_heading(const std::vector<std::string_view>& fields) {
  return std::none_of(fields.begin(), fields.end(),
                      [](std::string_view field) { return is_number(field) || is_nan_or_infinity(field); });
}

struct Columns {
  std::vector<double> times;  // s
  std::vector<double> values;
  std::vector<std::size_t> line_numbers;
  std::string heading;
};

double number_in(const LineReader& lines, std::string_view field) {
  const ScannedNumber number = parse_number(field);
  if (number.problem)
    lines.refuse(quoted(field) + " " + number.problem +
                 ". Each line must hold a time in s and an acceleration; begin remarks with '#'.");
  return number.value;
}

Columns parse_columns(const TextFile& file) {
  Columns columns;
  LineReader lines{file};
  std::string_view line;
  bool heading_allowed = true;
  while (lines.next(line)) {
    line = without_comment(line);
    if (line.empty()) continue;
    const std::vector<std::string_view> fields = fields_of(line);
    if (std::exchange(heading_allowed, false) && is_heading(fields)) {
      columns.heading = line;
      continue;
    }
    if (fields.size() != 2) {
      lines.refuse("expected two columns, time in s and acceleration, but found " + std::to_string(fields.size()) +
                   " in " + quoted(line) +
                   ". Separate the columns with blanks, a tab, a comma or a semicolon, and write decimals with a "
                   "point.");
    }
    columns.times.push_back(number_in(lines, fields[0]));
    columns.values.push_back(number_in(lines, fields[1]));
    columns.line_numbers.push_back(lines.line_number());
  }
  return columns;
}

/// The mean interval, after checking that all are alike.
double checked_time_step(const std::filesystem::path& path, const Columns& columns) {
  const std::vector<double>& times = columns.times;
  const double first_interval = times[1] - times[0];
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double interval = times[i] - times[i - 1];
    if (!(interval > 0.0)) {
      refuse_line(path, columns.line_numbers[i],
                  "the time " + to_text(times[i]) + " s does not follow after " + to_text(times[i - 1]) +
                      " s. Times must grow from line to line.");
    }
    if (std::abs(interval - first_interval) > spacing_tolerance * first_interval) {
      refuse_line(path, columns.line_numbers[i],
                  "the time interval is " + to_text(interval) + " s here but " + to_text(first_interval) +
                      " s at the beginning; they may differ by 1 part in 10000. Resample the record to a constant time "
                      "step, or write its times with more digits.");
    }
  }
  const double time_step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  const double tolerance = spacing_tolerance * time_step;
  if (std::abs(times[0]) > tolerance && std::abs(times[0] - time_step) > tolerance) {
    refuse_line(path, columns.line_numbers[0],
                "the first time is " + to_text(times[0]) + " s; it must be 0 s or one time step, " +
                    to_text(time_step) + " s. Shift the times so that the motion starts at 0 s.");
  }
  return time_step;
}

std::vector<std::string> notes_of(const Columns& columns, Acceleration unit, double time_step) {
  std::vector<std::string> notes;
  if (!columns.heading.empty()) notes.push_back("columns: " + columns.heading);
  notes.push_back("acceleration column in units of " + to_text(unit.si()) + " m/s^2");
  if (columns.times[0] > time_step / 2.0)
    notes.push_back("the file begins at " + to_text(columns.times[0]) + " s, taken as the start of the motion");
  return notes;
}

}  // namespace

bool begins_with_two_columns(const TextFile& file) {
  LineReader lines{file};
  std::string_view line;
  while (lines.next(line)) {
    line = without_comment(line);
    if (line.empty()) continue;
    const std::vector<std::string_view> fields = fields_of(line);
    return fields.size() == 2 && is_number(fields[0]) && is_number(fields[1]);
  }
  return false;
}

GroundMotion read_two_columns(const std::filesystem::path& path, Acceleration unit) {
  return parse_two_columns(read_text_file(path), unit);
}

GroundMotion parse_two_columns(const TextFile& file, Acceleration unit) {
  const std::filesystem::path& path = file.path;
  Check{"read_two_columns", path.native()}.positive(
      "unit", unit, "Give the unit of the acceleration column: 1 * g, or 1 * m / s / s.");
  Columns columns = parse_columns(file);
  if (columns.times.size() < 2) {
    refuse_file(path, "expected at least two lines with a time in s and an acceleration, but found " +
                          std::to_string(columns.times.size()) + ".");
  }
  const double time_step = checked_time_step(path, columns);
  for (double& value : columns.values) value *= unit.si();
  std::vector<std::string> notes = notes_of(columns, unit, time_step);
  return GroundMotion{path.stem().string(), time_step, std::move(columns.values), std::move(notes), file_of(file)};
}

}  // namespace moat
