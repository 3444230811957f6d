#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.hpp"
#include "base/text/number_format.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr std::size_t most_columns = 12, fewest_columns_of_series = 5;

std::string_view without_comment(std::string_view line) {
  return trimmed(line.substr(0, std::min(line.find_first_of("#%!"), line.find("//"))));
}

/// Puts the fields of a line into `fields`. Blanks around a comma or semicolon belong to it; two commas enclose an
/// empty field.
void divide(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  while (true) {
    const std::size_t end = line.find_first_of(" \t,;");
    fields.push_back(line.substr(0, end));
    if (end == std::string_view::npos) return;
    line = trimmed(line.substr(end));
    if (line.starts_with(',') || line.starts_with(';')) line = trimmed(line.substr(1));
  }
}

bool is_number(std::string_view field) { return parse_number(field).problem == nullptr; }

bool is_nan_or_infinity(std::string_view field) {
  std::string word = upper_case(field);
  if (word.starts_with('-') || word.starts_with('+')) word.erase(0, 1);
  return word == "NAN" || word == "INF" || word == "INFINITY";
}

bool is_word(std::string_view field) { return !field.empty() && !is_number(field) && !is_nan_or_infinity(field); }

/// Words only: a number among them, or a value such as NaN, means damaged data rather than a heading.
bool is_heading(const std::vector<std::string_view>& fields) {
  return std::ranges::none_of(fields,
                              [](std::string_view field) { return is_number(field) || is_nan_or_infinity(field); });
}

/// "dt = 0.02", "NPTS= 4000, DT= .005 SEC", "time step 5 ms", "sampling rate: 100 Hz", or "100 Hz" alone; s.
std::optional<double> step_in(std::string_view words) {
  const std::string capitals = upper_case(words.substr(0, 1000));
  const std::string_view text =
      trimmed(std::string_view{capitals}.substr(std::min(capitals.find_first_not_of("#%!/ \t"), capitals.size())));
  constexpr std::array intervals{"DT", "TIME STEP", "TIMESTEP", "TIME INTERVAL", "SAMPLING INTERVAL", "DELTA T"};
  for (const std::string_view word : intervals)
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      if (at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0) continue;
      std::string_view rest = text.substr(at + word.size());
      // Nothing but a sign of equality, and the unit of the time in brackets, may stand between.
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t=:"), rest.size()));
      bool in_milliseconds = false;
      if (take(rest, "(") || take(rest, "[")) {
        in_milliseconds = rest.starts_with("MS") || rest.starts_with("MILLI");
        rest.remove_prefix(std::min(rest.find_first_of("0123456789."), rest.size()));
      }
      rest = without_leading_blanks(rest);
      const ScannedNumber number = scan_number(rest);
      if (number.problem || !(number.value > 0.0)) continue;
      rest.remove_prefix(number.length);
      return in_milliseconds || take(rest, "MS") || take(rest, "MILLI") ? 1e-3 * number.value : number.value;
    }
  const std::size_t hertz = std::min(text.find("HZ"), text.find("SAMPLES PER SEC"));
  if (hertz == std::string_view::npos) return std::nullopt;
  const std::string_view before = trimmed(text.substr(0, hertz));
  const std::string_view last = before.substr(std::min(before.find_last_of(" \t=:") + 1, before.size()));
  const ScannedNumber rate = parse_number(last);
  const bool is_sampling = last.size() == before.size() || text.find("SAMPL") != std::string_view::npos;
  return rate.problem || !(rate.value > 0.0) || !is_sampling ? std::nullopt : std::optional{1.0 / rate.value};
}

/// The numbers of a file, row after row.
struct Rows {
  std::size_t columns = 0;
  std::vector<double> values{};
  std::vector<PrintedTime> first{};  ///< The first column, if there are others.
  std::vector<std::size_t> lines{};  ///< of the rows
  std::string heading{};
  std::optional<double> step{};  ///< s
};

constexpr const char* how_to_separate =
    ". Separate the columns with blanks, a tab, a comma or a semicolon, and write decimals with a point.";

Rows parse_rows(const TextFile& file) {
  Rows rows;
  LineReader lines{file};
  std::vector<std::string_view> fields;
  std::size_t announced = 0, last = 0;
  for (std::string_view whole; lines.next(whole);) {
    const std::string_view line = without_comment(whole);
    if (line.size() < whole.size() && !rows.step) rows.step = step_in(whole.substr(line.size()));
    if (line.empty()) continue;
    divide(line, fields);
    const bool is_first = rows.lines.empty() && rows.heading.empty();
    if (is_first) {
      const std::optional<double> step = is_number(fields[0]) && fields.size() < 3 ? std::nullopt : step_in(line);
      if (step || is_heading(fields)) {
        rows.heading = line;
        if (step) rows.step = step;
        continue;
      }
    }
    // "4000 0.005" above one column, or above more than two.
    if (rows.lines.size() == 1 && rows.columns == 2 && fields.size() != 2 && announced == 0 && is_number(fields[0])) {
      const double count = rows.values[0];
      if (count >= 2.0 && count <= 1e9 && count == std::round(count) && rows.values[1] > 0.0 && rows.values[1] < 1.0) {
        announced = static_cast<std::size_t>(count);
        const double step = rows.values[1];
        rows = {.heading = "count and step", .step = step};
      }
    }
    if (rows.columns == 0) rows.columns = fields.size();
    // The last row of a series may be shorter.
    if (fields.size() > rows.columns || (last != 0 && last < rows.columns) ||
        (fields.size() < rows.columns && rows.columns < fewest_columns_of_series))
      lines.refuse("expected " + std::to_string(rows.columns) + " columns, as above, but found " +
                   std::to_string(fields.size()) + " in " + quoted(line) + how_to_separate);
    last = fields.size();
    for (const std::string_view field : fields) {
      const ScannedNumber number = parse_number(field);
      if (number.problem)
        lines.refuse(quoted(field) + " " + number.problem + ". Each line must hold numbers; begin remarks with '#'.");
      rows.values.push_back(number.value);
    }
    if (rows.columns > 1)
      rows.first.push_back({first_number(fields[0]).value_or(PrintedNumber{}), lines.line_number()});
    rows.lines.push_back(lines.line_number());
  }
  if (announced != 0 && announced != rows.values.size())
    refuse_file(file.path, "the first line announces " + std::to_string(announced) + " values, but the file holds " +
                               std::to_string(rows.values.size()) + ".");
  return rows;
}

/// Words between commas.
std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  std::vector<std::string_view> fields;
  divide(trimmed(list), fields);
  for (const std::string_view field : fields) words.emplace_back(field);
  return words;
}

[[noreturn]] void ask_for_columns(const TextFile& file, const std::string& problem) {
  refuse_file(file.path, problem +
                             " Name them: --record-columns x,y, or time,x,y,z, with - for columns that are not used"
                             ", or series, and the step: --record-step \"0.01 s\".");
}

/// The meaning of the columns; empty for a series.
std::vector<std::string> meaning_of(const TextFile& file, const Rows& rows, const std::string& given) {
  const std::string name = file.path.filename().string();
  if (given == "series" || (given.empty() && rows.columns == 1)) return {};
  if (!given.empty()) {
    const std::vector<std::string> words = words_of(given);
    std::array<std::size_t, 4> uses{};
    for (const std::string& word : words) {
      const std::size_t kind = std::string_view{"xyzt"}.find(word == "time" ? 't' : word.size() == 1 ? word[0] : '?');
      if (word == "-") continue;
      if (kind >= uses.size() || word == "t" || ++uses[kind] > 1 || (kind == 3 && &word != words.data()))
        throw InputError{"--record-columns: \"" + given +
                         "\" is not allowed; it must be \"series\", or x, y, z and - between commas, each once, with "
                         "or without \"time\" in front."};
    }
    if (words.size() != rows.columns)
      refuse_file(file.path, "it has " + std::to_string(rows.columns) + " columns, but --record-columns names " +
                                 std::to_string(words.size()) + ": " + given + ".");
    return words;
  }
  const bool decreases = std::ranges::adjacent_find(rows.first, [](const PrintedTime& one, const PrintedTime& two) {
                           return two.time.value < one.time.value;
                         }) != rows.first.end();
  const std::string columns = std::to_string(rows.columns) + " columns";
  if (rows.columns >= fewest_columns_of_series && rows.columns <= most_columns && decreases) return {};
  if (rows.columns == 2 && !decreases) return {"time", "x"};
  ask_for_columns(
      file, "the file has " + columns + (decreases ? ", of which the first does not grow, so it is no time." : "."));
}

double step_of_text(const TextFile& file, const Rows& rows, bool has_times, const std::optional<Time>& given,
                    RecordChannel& channel) {
  std::optional<double> step = rows.step;
  if (given) {
    Check{"read_motion", file.path.native()}.positive("step", *given, "Give the time between samples, 0.01 * s.");
    step = given->si();
    if (rows.step && std::abs(*rows.step - *step) > 1e-6 * *step)
      channel.warnings.push_back("the file says a step of " + to_text(*rows.step) + " s; " + to_text(*step) +
                                 " s were given");
  }
  if (!has_times) {
    if (!step) refuse_file(file.path, "it does not say its time step. Give it: --record-step \"0.01 s\".");
    return *step;
  }
  const double time_step = even_step(file.path, rows.first, step), first = rows.first[0].time.value,
               tolerance = 1e-4 * time_step + 0.51 * rows.first[0].time.digit;
  if (std::abs(first) > 1e-4 * time_step && std::abs(first - time_step) > tolerance)
    refuse_line(file.path, rows.lines[0],
                "the first time is " + to_text(first) + " s; it must be 0 s or one time step, " + to_text(time_step) +
                    " s. Shift the times so that the motion starts at 0 s.");
  if (first > 0.5 * time_step)
    channel.notes.push_back("the file begins at " + to_text(first) + " s, taken as the start of the motion");
  return time_step;
}

}  // namespace

bool is_plain_text(const TextFile& file) {
  LineReader lines{file};
  std::vector<std::string_view> fields;
  int words = 0;
  for (std::string_view line; lines.next(line);) {
    line = without_comment(line);
    if (line.empty()) continue;
    divide(line, fields);
    // A table of names and numbers below one heading is another file.
    if (is_number(fields[0])) return words == 0 || std::ranges::none_of(fields, is_word);
    if (++words > 1) return false;
  }
  return false;
}

std::vector<RecordChannel> read_plain_text(const TextFile& file, const TextColumns& columns) {
  const Rows rows = parse_rows(file);
  if (rows.columns > most_columns)
    refuse_line(file.path, rows.lines[0], "found " + std::to_string(rows.columns) + " columns; 1 to 12 are read.");
  if (rows.values.size() < 2 || (rows.columns > 1 && rows.lines.size() < 2))
    refuse_file(file.path,
                "expected at least two lines of numbers, but found " + std::to_string(rows.lines.size()) + ".");
  const std::vector<std::string> meaning = meaning_of(file, rows, columns.columns);
  if (!meaning.empty() && rows.values.size() != rows.columns * rows.lines.size())
    refuse_line(file.path, rows.lines.back(), "the last row is not complete.");
  if (!columns.unit)
    throw MissingUnit{
        "read_motion \"" + file.path.string() + "\": plain text does not say the unit of its accelerations.",
        "Give the unit: read_motion(file, 1 * g), or 1 * m / s / s."};
  Check{"read_motion", file.path.native()}.positive("unit", *columns.unit,
                                                    "Give the unit of the accelerations: 1 * g, or 1 * m / s / s.");
  RecordChannel common{.format = "text", .columns = columns.columns};
  if (!rows.heading.empty()) common.notes.push_back("columns: " + rows.heading);
  common.notes.push_back("accelerations in units of " + to_text(columns.unit->si()) + " m/s^2");
  common.step = step_of_text(file, rows, !meaning.empty() && meaning[0] == "time", columns.step, common);
  common.unit = to_exact(columns.unit->si()) + " m/s^2";
  const auto named =
      std::ranges::count_if(meaning, [](const std::string& word) { return word != "-" && word != "time"; });
  std::vector<RecordChannel> channels;
  const auto add = [&](const std::string& name, std::size_t first, std::size_t every) {
    RecordChannel& channel = channels.emplace_back(common);
    for (std::size_t i = first; i < rows.values.size(); i += every)
      channel.samples.push_back(columns.unit->si() * rows.values[i]);
    if (named > 1 || name == "z") set_component(channel, name, "--record-columns");
  };
  if (meaning.empty()) add("", 0, 1);
  for (std::size_t i = 0; i < meaning.size(); ++i)
    if (meaning[i] != "-" && meaning[i] != "time") add(meaning[i], i, rows.columns);
  if (channels.empty())
    refuse_file(file.path, "no column is named x, y or z: --record-columns " + columns.columns + ".");
  return channels;
}

}  // namespace moat
