#include <algorithm>
#include <array>
#include <utility>

#include "base/check.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr std::size_t csmip_text_lines = 25;
constexpr FortranFormat csmip_integers{16, 5, true}, csmip_reals{8, 10, false};
constexpr double csmip_unknown = -999.0;

/// Azimuth in the header: 0 to 360; 500 up, 600 down, 1100 H1, 1200 H2, 900 unknown.
std::string component_of_code(double code) {
  return code == 500.0                  ? "UP"
         : code == 600.0                ? "DOWN"
         : code == 1100.0               ? "H1"
         : code == 1200.0               ? "H2"
         : code >= 0.0 && code <= 360.0 ? to_text(code)
                                        : "";
}

/// "Chan  1: 360 Deg" of line 8, and value 27 of the header.
void set_csmip_component(RecordLines& lines, RecordChannel& channel, double code) {
  const std::string_view line = channel.notes[7];
  std::string_view word = line.substr(std::min(line.find(':') + 1, line.size()));
  word = trimmed(word.substr(0, word.find('(')));
  const std::string in_header = component_of_code(code);
  if (!set_component(channel, word)) {
    if (!set_component(channel, in_header))
      lines.refuse("neither line 8 of the channel, " + quoted(line) + ", nor value 27 of the header, " + to_text(code) +
                   ", is a component.");
    return;
  }
  const std::optional<ComponentWord> header = component_word(in_header);
  if (!header || header->vertical != channel.vertical || header->azimuth != channel.azimuth)
    channel.warnings.push_back("azimuth " + to_text(code) + " in the header, " + quoted(word) +
                               " in the text: text taken");
}

/// "Start time:  2/13/12, 21:06:45.0 UTC (GPS)" of line 5, or "TRIGGER TIME: 05/02/83, 16:42:48.2 PDT"; nothing for a
/// zone that is not stated or not known.
std::optional<double> csmip_start(std::string_view line) {
  const std::string capitals = upper_case(line);
  std::string_view text = capitals;
  if (!take_behind(text, "TIME:")) return std::nullopt;
  constexpr std::array<std::pair<std::string_view, double>, 4> zones{
      {{"UTC", 0.0}, {"GMT", 0.0}, {"PST", 8.0}, {"PDT", 7.0}}};
  for (const auto& [zone, hours_behind] : zones) {
    const std::vector<double> date = numbers_in(text.substr(0, text.find(zone)));
    if (text.find(zone) == std::string_view::npos || date.size() != 6) continue;
    const double year = date[2] + (date[2] < 70.0 ? 2000.0 : date[2] < 100.0 ? 1900.0 : 0.0);
    if (const auto local = utc_seconds({year, date[0], date[1], date[3], date[4], date[5]}))
      return *local + 3600.0 * hours_behind;
  }
  return std::nullopt;
}

/// The unit and the format in " 2000 points of accel data equally spaced at .02 sec, in cm/sec2. (8f10.6)".
FortranFormat format_and_unit(RecordLines& lines, RecordChannel& channel, std::string_view line) {
  const std::string capitals = upper_case(line);
  for (const char* unit : {"CM/SEC/SEC", "CM/SEC2", "CM/S/S", "CM/S2"})
    if (capitals.find(unit) != std::string::npos) channel.unit = unit;
  if (channel.unit.empty()) lines.refuse("expected the unit, cm/sec2, in " + quoted(line) + ".");
  channel.unit = "cm/s^2";
  const std::size_t bracket = line.rfind('(');
  if (bracket != std::string_view::npos)
    if (const auto format = fortran_format(line.substr(bracket))) return *format;
  channel.warnings.emplace_back("no format is stated; read as 8 columns of 10 characters");
  return csmip_reals;
}

std::optional<std::size_t> points_of(std::string_view line, std::string_view quantity) {
  const std::string capitals = upper_case(line);
  std::string_view rest = capitals;
  const std::optional<std::size_t> count = take_whole_number(rest);
  return take(rest, "POINTS OF") && take(rest, quantity) ? count : std::nullopt;
}

}  // namespace

bool is_csmip(const TextFile& file) {
  LineReader lines{file};
  std::string_view one, two;
  if (!lines.next(one) || !lines.next(two)) return false;
  const std::string first = upper_case(one), second = upper_case(two);
  return first.find("CORRECTED ACCELEROGRAM") != std::string::npos && first.find("UNCORRECTED") == std::string::npos &&
         second.find("UNCORRECTED ACCELEROGRAM DATA") != std::string::npos;
}

std::vector<RecordChannel> read_csmip(const TextFile& file) {
  RecordLines lines{file};
  std::vector<RecordChannel> channels;
  for (std::string_view first; lines.next_filled(first);) {
    if (upper_case(first).find("CORRECTED ACCELEROGRAM") == std::string::npos)
      lines.refuse("expected the beginning of a channel, \"Corrected accelerogram\", but found " + quoted(first) + ".");
    RecordChannel channel{.format = "CSMIP V2", .network = "CSMIP"};
    const std::string title{trimmed(first)};
    channel.notes = lines.text(csmip_text_lines - 1, "the last of its 25 lines of text");
    channel.notes.insert(channel.notes.begin(), title);
    // "Station No. 89146   40.941N, 123.633W"; old files are in capitals.
    const std::string site = upper_case(channel.notes[5]);
    std::string_view station = site;
    if (take(station, "STATION") && (take(station, "NO") || take(station, "ID"))) take(station, ".");
    station = trimmed(station);
    channel.station = station.substr(0, station.find(' '));
    if (channel.station.empty()) lines.refuse("expected \"Station No. 89146\" in line 6 of the channel.");
    channel.event = trimmed(channel.notes[2].substr(0, channel.notes[2].find("   ")));
    channel.start = csmip_start(channel.notes[4]);
    const std::vector<double> integers = lines.numbers(100, csmip_integers, "the header of whole numbers"),
                              reals = lines.numbers(100, csmip_reals, "the header of numbers");
    set_csmip_component(lines, channel, integers[26]);
    const std::string_view line = lines.line("the line above its accelerations");
    const std::optional<std::size_t> count = points_of(line, "ACCEL");
    if (!count) lines.refuse("expected \" 2000 points of accel data\", but found " + quoted(line) + ".");
    const std::string words = upper_case(line);
    std::string_view rest = words;
    std::optional<PrintedNumber> step;
    if (take_behind(rest, "SPACED AT")) step = first_number(rest);
    channel.step = reals[60] > 0.0 ? reals[60] : step ? step->value : 0.0;
    if (!(channel.step > 0.0)) lines.refuse("there is no step > 0 s, neither here nor in value 61 of the header.");
    if (step && std::abs(step->value - channel.step) > 0.51 * step->digit)
      lines.refuse("the step is " + to_text(step->value) + " s here, and " + to_text(channel.step) +
                   " s in value 61 of the header.");
    const FortranFormat format = format_and_unit(lines, channel, line);
    if (reals[65] != csmip_unknown && reals[65] != 0.0)
      state_peak(channel, reals[65], 0.01);
    else
      state_peak(channel,
                 std::string_view{channel.notes[17]}.substr(
                     std::min(channel.notes[17].find('=') + 1, channel.notes[17].size())),
                 0.01);
    set_samples(channel, lines.numbers(*count, format, "acceleration"));
    std::string_view after;
    bool counted = false;  // The line behind the accelerations shows whether their number is right.
    while (lines.next_filled(after) && !after.starts_with("/&")) {
      if (!std::exchange(counted, true) && !points_of(after, "VELOC"))
        lines.refuse("expected the velocities or \"/&\" behind " + std::to_string(*count) +
                     " accelerations, but found " + quoted(after) + ".");
    }
    if (!after.starts_with("/&"))
      lines.refuse("expected the end of the channel, \"/&\". The file was cut; fetch it again.");
    channels.push_back(std::move(channel));
  }
  return channels;
}

}  // namespace moat
