// BHRC (Iran) and RENADIC (Chile) descend from the same layout of Caltech: 13 + 7 + 7 lines in front of each channel.
#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/units.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr std::size_t volume_text_lines = 13, volume_number_lines = 14;
constexpr FortranFormat bhrc_values{10, 13, false}, renadic_values{10, 7, false};

bool line_has(const TextFile& file, std::size_t number, std::string_view words) {
  LineReader lines{file};
  std::string_view line;
  while (lines.line_number() < number)
    if (!lines.next(line)) return false;
  return upper_case(line).find(words) != std::string::npos;
}

struct Volume {
  RecordChannel channel;
  std::size_t count;
  double duration;
};

/// The text of a channel, which begins with `first`; line 11 has count and duration, line 12 the unit.
Volume volume_header(RecordLines& lines, std::string_view first, const std::string& format) {
  Volume volume{{.format = format, .unit = "g/10", .level = RecordLevel::uncorrected}, 0, 0.0};
  std::vector<std::string>& notes = volume.channel.notes;
  notes.emplace_back(trimmed(first));
  for (const std::string& line : lines.text(volume_text_lines - 1, "the last of its 13 lines of text"))
    notes.push_back(line);
  const std::vector<double> numbers = numbers_in(notes[10].substr(std::min(notes[10].find('='), notes[10].size())));
  if (numbers.size() < 2 || !(numbers[0] >= 2.0 && numbers[0] < 1e9) || !(numbers[1] > 0.0))
    lines.refuse("expected count and duration in line 11 of the channel, but found " + moat::quoted(notes[10]) + ".");
  const std::string unit = upper_case(notes[11]);
  // G/100 is another one.
  const std::size_t at = unit.find("G/10");
  if (at == std::string::npos || unit.substr(at + 4, 1) == "0")
    lines.refuse("expected the unit G/10 in line 12 of the channel, but found " + moat::quoted(notes[11]) + ".");
  volume.count = static_cast<std::size_t>(numbers[0]);
  volume.duration = numbers[1];
  // These headers repeat facts of the text, and lines of BHRC are cut.
  lines.skip(volume_number_lines, "the last of its headers of numbers");
  return volume;
}

void check_volume_end(RecordLines& lines) {
  std::string_view line;
  if (!lines.next_filled(line) || !line.starts_with("/&"))
    lines.refuse(
        "expected \"/&\" behind the last value. The number of values in line 11 of the channel is wrong, or the file "
        "was cut.");
}

}  // namespace

bool is_bhrc(const TextFile& file) {
  return upper_case(file.text.substr(0, 5)) == "* VOL" && line_has(file, 7, "COMP");
}

std::vector<RecordChannel> read_bhrc(const TextFile& file) {
  RecordLines lines{file};
  std::vector<RecordChannel> channels;
  for (std::string_view first; lines.next_filled(first);) {
    auto [channel, count, duration] = volume_header(lines, first, "BHRC");
    channel.network = "BHRC";
    // "Ahar   Station  38.474 N ...  Azimuth L 352   T 82"
    const std::string site = upper_case(channel.notes[7]), component = upper_case(trimmed(channel.notes[4]));
    channel.station = trimmed(std::string_view{channel.notes[7]}.substr(0, site.find("STATION ")));
    channel.event = channel.notes[0] + " " + channel.notes[2];
    if (!set_component(channel, component))
      lines.refuse("the component " + quoted(component) + " is none of L, V and T.");
    std::string_view azimuths = site;
    if (take_behind(azimuths, "AZIMUTH") && take_behind(azimuths, " " + component + " ") && !channel.vertical)
      if (const auto azimuth = take_whole_number(azimuths))
        channel.azimuth = std::fmod(static_cast<double>(*azimuth), 360.0);
    channel.step = duration / static_cast<double>(count);
    set_samples(channel, lines.numbers(count, bhrc_values, "acceleration"));
    check_volume_end(lines);
    channels.push_back(std::move(channel));
  }
  return channels;
}

bool is_renadic(const TextFile& file) { return line_has(file, 8, "RENADIC"); }

std::vector<RecordChannel> read_renadic(const TextFile& file) {
  RecordLines lines{file};
  std::vector<RecordChannel> channels;
  for (std::string_view first; lines.next_filled(first);) {
    auto [channel, count, duration] = volume_header(lines, first, "RENADIC");
    channel.network = "RENADIC";
    channel.station = trimmed(channel.notes[5]);
    // Digitised films may have no date; the number of the record stands in line 2.
    channel.event = channel.notes[1] + " " + channel.notes[2].substr(0, channel.notes[2].find("   "));
    std::string_view component = channel.notes[6];
    take_behind(component, ":");
    component = trimmed(component.substr(0, component.find('(')));
    if (!set_component(channel, component))
      lines.refuse("the component " + quoted(component) + " is none of L, V and T.");
    std::string_view peak = channel.notes[11];
    if (take_behind(peak, "MAX ") && take_behind(peak, "=")) state_peak(channel, peak, standard_gravity);
    const std::size_t before = lines.line_number();
    const std::vector<double> pairs = lines.numbers(2 * count, renadic_values, "time and acceleration");
    std::vector<PrintedTime> times;
    std::vector<double> values;
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
      times.push_back({{pairs[i], 1e-3}, before + 1 + i / renadic_values.per_line});
      values.push_back(pairs[i + 1]);
    }
    channel.step = even_step(file.path, times, duration / static_cast<double>(count));
    set_samples(channel, values);
    check_volume_end(lines);
    channels.push_back(std::move(channel));
  }
  return channels;
}

}  // namespace moat
