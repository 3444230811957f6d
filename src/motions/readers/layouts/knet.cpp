#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/check.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr std::size_t knet_header_lines = 17, key_width = 18;

/// m/s^2 of one count in "3920(gal)/6182761".
double unit_of_count(const TextFile& file, const std::string& factor) {
  std::string_view rest = factor;
  const ScannedNumber scale = scan_number(rest);
  rest.remove_prefix(scale.length);
  if (!scale.problem && take(rest, "(gal)/"))
    if (const ScannedNumber counts = parse_number(trimmed(rest)); !counts.problem && counts.value > 0.0)
      return 0.01 * scale.value / counts.value;
  refuse_file(file.path, "Scale Factor " + quoted(factor) + " is not of the form \"3920(gal)/6182761\".");
}

std::vector<double> counts_of(RecordLines& lines, double count) {
  std::vector<double> counts;
  for (std::string_view line; lines.next_filled(line);)
    for (line = trimmed(line); !line.empty(); line = without_leading_blanks(line)) {
      const std::string_view word = line.substr(0, line.find_first_of(" \t"));
      const ScannedNumber number = parse_number(word);
      if (number.problem) lines.refuse(quoted(word) + " " + number.problem + ". The data are whole numbers.");
      counts.push_back(number.value);
      line.remove_prefix(word.size());
    }
  if (std::abs(static_cast<double>(counts.size()) - count) > 0.5)
    lines.refuse("the file ends with " + std::to_string(counts.size()) + " values, but frequency and duration make " +
                 to_text(count) + ". It was cut; fetch it again.");
  return counts;
}

}  // namespace

bool is_knet(const TextFile& file) {
  LineReader lines{file};
  std::string_view line;
  bool begins = false;
  while (lines.line_number() < 6 && lines.next(line)) {
    if (lines.line_number() == 1) begins = line.starts_with("Origin Time");
    if (lines.line_number() == 6) return begins && line.starts_with("Station Code");
  }
  return false;
}

std::vector<RecordChannel> read_knet(const TextFile& file) {
  RecordLines lines{file};
  RecordChannel channel{.format = "K-NET", .network = "NIED", .unit = "gal", .level = RecordLevel::raw};
  channel.notes = lines.text(knet_header_lines, "the last of its 17 header lines");
  HeaderKeys keys{file};
  for (const std::string_view line : channel.notes)
    keys.set(trimmed(line.substr(0, key_width)), trimmed(line.substr(std::min(key_width, line.size()))));
  channel.station = keys.value("STATION CODE");
  channel.event = keys.find("ORIGIN TIME");
  constexpr double japan = 9.0 * 3600.0, delay = 15.0;
  if (const auto time = utc_seconds(numbers_in(keys.find("RECORD TIME")))) channel.start = *time - japan - delay;
  const double frequency = keys.positive("SAMPLING FREQ(HZ)", "Hz");
  channel.step = 1.0 / frequency;
  std::string direction = keys.value("DIR.");
  constexpr std::array<const char*, 3> directions{"N-S", "E-W", "U-D"};
  if (direction.size() == 1 && direction[0] >= '1' && direction[0] <= '6') {
    const int sensor = direction[0] - '1';
    channel.format = "KiK-net";
    channel.location = sensor < 3 ? "borehole" : "surface";
    if (sensor < 3) channel.warnings.emplace_back("the sensor in the borehole may be turned by many degrees");
    direction = directions[static_cast<std::size_t>(sensor % 3)];
  }
  if (std::ranges::find(directions, direction) == directions.end() || !set_component(channel, direction))
    refuse_file(file.path, "Dir. " + moat::quoted(direction) + " is none of N-S, E-W, U-D and 1 to 6.");
  const double unit = unit_of_count(file, keys.value("SCALE FACTOR"));
  channel.samples = counts_of(lines, frequency * keys.positive("DURATION TIME(S)", "s"));
  const double mean = std::accumulate(channel.samples.begin(), channel.samples.end(), 0.0) /
                      static_cast<double>(channel.samples.size());
  for (double& sample : channel.samples) sample = unit * (sample - mean);
  // The documentation has it without the first point.
  state_peak(channel, keys.find("MAX. ACC. (GAL)") + keys.find("MAX ACC. (GAL)"), 0.01);
  return {channel};
}

}  // namespace moat
