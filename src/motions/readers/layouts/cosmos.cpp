#include <algorithm>
#include <cmath>
#include <map>

#include "base/check.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr double unknown = -999.0;
// Numbers of values in the headers, from 1.
constexpr std::size_t quantity_value = 2, unit_value = 3, azimuth_value = 54, interval_value = 62, length_value = 63,
                      peak_value = 64;
constexpr std::string_view first_words = "(FORMAT V";

/// Names of units of acceleration by their number in the format's table.
const std::map<std::size_t, const char*> cosmos_units{{2, "g"}, {4, "cm/s^2"}, {7, "in/s^2"}, {10, "gal"}, {11, "mg"}};
constexpr const char* known_cosmos_units = "02 (g), 04 (cm/s^2), 07 (in/s^2), 10 (gal) and 11 (mg)";

/// The count in front of a line such as " 100 Integer-header values follow on  10 lines, Format= (10I8)". `words` are
/// in capitals; letters of `between` may stand before them.
std::optional<std::size_t> count_before(std::string_view line, std::string_view words, std::string_view between = " ") {
  const std::string capitals = upper_case(line);
  std::string_view rest = capitals;
  const std::optional<std::size_t> count = take_whole_number(rest);
  const std::size_t place = rest.find(words);
  const bool fits = rest.starts_with(' ') && place < rest.size() && rest.find_first_not_of(between) >= place;
  return fits ? count : std::nullopt;
}

FortranFormat format_in(RecordLines& file, std::string_view line) {
  const std::string capitals = upper_case(line);
  std::string_view rest = capitals;
  rest.remove_prefix(std::min(rest.rfind("FORMAT"), rest.size()));
  if (take(rest, "FORMAT") && take(rest, "=") && without_leading_blanks(rest).starts_with('('))
    if (const std::optional<FortranFormat> format = fortran_format(rest)) return *format;
  file.refuse("expected a Fortran format such as Format=(8F10.5) at the end of this line, but found " +
              quoted(trimmed(line)) + ".");
}

std::vector<double> header(RecordLines& file, const std::string& kind, std::size_t needed) {
  const std::string what = "the " + kind + " header";
  const std::string_view line = file.line(what);
  const std::optional<std::size_t> count = count_before(line, upper_case(kind) + "-HEADER VALUES");
  if (!count)
    file.refuse("expected the line \" 100 " + kind + "-header values follow on ...\", but found " +
                quoted(trimmed(line)) + ". The number of text lines in the first line may be wrong.");
  if (*count < needed)
    file.refuse(what + " has " + std::to_string(*count) + " values; " + std::to_string(needed) + " are needed.");
  return file.numbers(*count, format_in(file, line), what);
}

std::vector<std::string> text_lines(RecordLines& file, std::string_view line) {
  const std::string capitals = upper_case(line);
  std::string_view rest = capitals;
  std::optional<std::size_t> count;
  if (take_behind(rest, first_words) && rest.find_first_not_of(" .0123456789") == rest.find("WITH ") &&
      take_behind(rest, "WITH "))
    count = take_whole_number(rest);
  if (!count || !take(rest, "TEXT LINES)"))
    file.refuse("expected \"(Format v01.20 with 13 text lines)\", but found " + quoted(trimmed(line)) + ".");
  std::vector<std::string> lines{std::string{trimmed(line)}};
  while (lines.size() < *count) lines.emplace_back(trimmed(file.line("the last of its lines of text")));
  return lines;
}

std::vector<std::string> comments_of(RecordLines& file) {
  const std::string_view line = file.line("the comments");
  const std::optional<std::size_t> count = count_before(line, "COMMENT");
  if (!count)
    file.refuse("expected the line \"  2 Comment line(s) follow ...\", but found " + quoted(trimmed(line)) + ".");
  std::vector<std::string> comments;
  while (comments.size() < *count)
    if (!comments.emplace_back(trimmed(file.line("the last comment"))).starts_with('|'))
      file.refuse("expected " + std::to_string(*count) + " lines of comment, each with \"|\" in front.");
  return comments;
}

/// The number of the unit in "units=cm/sec2(04)" or "units=cm/sec2 (04)".
std::size_t unit_in(RecordLines& file, std::string_view line, double number_in_header) {
  const std::string capitals = upper_case(line);
  std::string_view rest = capitals;
  std::optional<std::size_t> number;
  std::string_view name;
  if (take_behind(rest, "UNITS") && take(rest, "=")) {
    name = trimmed(rest.substr(0, rest.find('(')));
    if (take_behind(rest, "(")) number = take_whole_number(rest);
  }
  if (!number || !take(rest, ")"))
    file.refuse("expected the unit with its number, as \"units=cm/sec2(04)\", but found " + quoted(trimmed(line)) +
                ".");
  const auto known = cosmos_units.find(*number);
  if (const auto named = acceleration_unit(name);
      named && known != cosmos_units.end() && std::abs(*named - *acceleration_unit(known->second)) > 1e-9)
    file.refuse("the unit is " + quoted(name) + ", but its number " + std::to_string(*number) + " stands for " +
                known->second + ".");
  if (number_in_header != unknown && number_in_header != static_cast<double>(*number))
    file.refuse("the unit is number " + std::to_string(*number) + " here, but value 3 of the integer header is " +
                to_text(number_in_header) + ".");
  return *number;
}

double checked_interval(RecordLines& file, const std::vector<double>& real_header, std::size_t count) {
  const double milliseconds = real_header[interval_value - 1], length = real_header[length_value - 1];
  if (!(milliseconds > 0.0))
    file.refuse("value 62 of the real header, the interval of the samples, is " + to_text(milliseconds) +
                " ms; it must be > 0 ms.");
  const double interval = 1e-3 * milliseconds;
  const double by_count = interval * static_cast<double>(count);
  // Files count their length with and without the interval behind the last sample.
  if (length != unknown && std::abs(length - by_count) > 0.01 * by_count + interval)
    file.refuse(std::to_string(count) + " values at intervals of " + to_text(milliseconds) + " ms last " +
                to_text(by_count) + " s, but value 63 of the real header, the length, is " + to_text(length) + " s.");
  return interval;
}

void check_end(RecordLines& file) {
  std::string_view line;
  if (!file.next_filled(line))
    file.refuse("expected \"End-of-data\" behind the last value. The file was cut; fetch it again.");
  if (!upper_case(trimmed(line)).starts_with("END-OF-DATA") && !line.starts_with("/&"))
    file.refuse("expected \"End-of-data\" behind the last value, but found " + quoted(trimmed(line)) +
                ". The number of values in the line above the data may be wrong.");
}

/// The component by value 54 of the integer header, else by line 9 of the text, "Sta Chan 1: 340 deg", else by the
/// comment |<SCNL>BMR.BNZ.AK.--, whose channel also shows that a component is vertical.
void set_cosmos_component(RecordChannel& channel, double code, const std::vector<std::string>& comments) {
  static const std::map<double, const char*> names{{400, "UP"}, {401, "DOWN"}, {402, "VERTICAL"},
                                                   {500, "R"},  {501, "T"},    {600, "L"},
                                                   {601, "T"},  {700, "H1"},   {701, "H2"}};
  std::string station;
  for (const std::string& comment : comments) {
    const std::string capitals = upper_case(comment);
    std::string_view rest = capitals;
    if (take_behind(rest, "<SCNL>")) station = trimmed(rest.substr(0, rest.find(' ')));
  }
  const std::size_t one = std::min(station.find('.'), station.size()),
                    two = std::min(station.find('.', one + 1), station.size()),
                    three = std::min(station.find('.', two + 1), station.size());
  const std::string code_of_channel = two > one ? station.substr(one + 1, two - one - 1) : "";
  const bool is_vertical = code_of_channel.ends_with('Z');
  if (two > one) {
    channel.station = station.substr(0, one);
    channel.network = two < three ? station.substr(two + 1, three - two - 1) : "";
  }
  const auto name = names.find(code);
  if (is_vertical)
    set_component(channel, code == 401.0 ? "DOWN" : "Z");
  else if (name != names.end())
    set_component(channel, name->second);
  else if (code >= 1.0 && code <= 360.0)
    set_component(channel, to_text(code));
  else {
    // "Sta Chan  1: 340 deg (Rcrdr Chan  1) Location: ..." or "Sta Cha:  1: 340 deg"
    const std::string line = channel.notes.size() > 8 ? upper_case(channel.notes[8]) : "";
    std::string_view text = std::string_view{line}.substr(0, std::min(line.find('('), line.find("LOCATION")));
    if (!take_behind(text, "STA CHA") || !set_component(channel, text.substr(text.rfind(':') + 1)))
      set_component(channel, code_of_channel);
  }
  // The word "DOWN" turns the samples, and stays.
  if (channel.component.empty() || (is_vertical && code != 401.0 && !code_of_channel.empty()))
    channel.component = code_of_channel;
}

/// A channel; the reason why it is left out where it holds something else than acceleration.
struct Series {
  RecordChannel channel;
  std::string other{};
};

Series read_series(RecordLines& file, std::string_view first) {
  Series series{{.format = "COSMOS"}};
  RecordChannel& channel = series.channel;
  channel.notes = text_lines(file, first);
  const std::string title = upper_case(channel.notes[0]);
  if (title.starts_with("UNCOR")) channel.level = RecordLevel::uncorrected;
  const std::vector<double> integers = header(file, "Integer", unit_value);
  const std::vector<double> reals = header(file, "Real", length_value);
  const std::vector<std::string> comments = comments_of(file);
  const std::string_view line = file.line("the data");
  const std::optional<std::size_t> count = count_before(line, " PTS", "ABCDEFGHIJKLMNOPQRSTUVWXYZ. ");
  if (!count)
    file.refuse("expected the line \" 4000 acceleration pts, approx  80 secs, units=...\", but found " +
                quoted(trimmed(line)) + ".");
  if (*count < 2) file.refuse(std::to_string(*count) + " values are not enough; there must be >= 2.");
  const double quantity = integers[quantity_value - 1];
  const bool says_acceleration = upper_case(line).find("ACCEL") != std::string::npos;
  const std::size_t unit = unit_in(file, line, integers[unit_value - 1]);
  const auto name = cosmos_units.find(unit);
  if (quantity != 1.0 && !(quantity == unknown && says_acceleration))
    series.other = "value 2 of the integer header is " + to_text(quantity) + "; only 1, acceleration, is read.";
  else if (name == cosmos_units.end())
    series.other =
        "unit number " + std::to_string(unit) + " is not one of acceleration; known are " + known_cosmos_units +
        (title.find("COUNT") != std::string::npos || unit == 50 ? ". Raw counts of the recorder: take V1 or V2."
                                                                : ". Take the file with processed acceleration.");
  channel.step = checked_interval(file, reals, *count);
  if (channel.notes.size() > 4) {
    const std::string site = upper_case(channel.notes[4]);
    std::string_view code = site;
    if (take_behind(code, "CODE:")) code = trimmed(code), channel.station = code.substr(0, code.find(' '));
  }
  channel.event = channel.notes.size() > 3 ? channel.notes[3] : "";
  // Year, day of the year, month, day, hour, minute.
  if (integers.size() > 44 && reals.size() > 29 && reals[29] != unknown)
    channel.start = utc_seconds({integers[39], integers[41], integers[42], integers[43], integers[44], reals[29]});
  set_cosmos_component(channel, integers.size() >= azimuth_value ? integers[azimuth_value - 1] : unknown, comments);
  const FortranFormat format = format_in(file, line);
  const std::vector<double> values = file.numbers(*count, format, "acceleration");
  if (series.other.empty()) {
    channel.unit = name->second;
    if (reals.size() >= peak_value && reals[peak_value - 1] != unknown)
      state_peak(channel, reals[peak_value - 1], acceleration_unit(channel.unit).value());
    set_samples(channel, values);
  }
  check_end(file);
  return series;
}

}  // namespace

bool is_cosmos(const TextFile& file) {
  LineReader lines{file};
  std::string_view first;
  return lines.next(first) && upper_case(first).find(first_words) != std::string::npos;
}

std::vector<RecordChannel> read_cosmos(const TextFile& text) {
  RecordLines file{text};
  std::vector<RecordChannel> channels;
  std::string others;
  std::size_t number = 0;
  for (std::string_view first; file.next_filled(first);) {
    Series series = read_series(file, first);
    ++number;
    if (series.other.empty())
      channels.push_back(std::move(series.channel));
    else
      others += (others.empty() ? "channel " : "; channel ") + std::to_string(number) + " is left out: " + series.other;
  }
  if (channels.empty())
    throw NotARecord{text.path.string() + ": " + (others.empty() ? "there is no channel." : others)};
  if (!others.empty())
    for (RecordChannel& channel : channels) channel.warnings.push_back(others);
  return channels;
}

}  // namespace moat
