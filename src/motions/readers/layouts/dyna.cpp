#include <algorithm>
#include <cmath>
#include <optional>

#include "base/check.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr std::string_view format_of_fixed_length = "DYNA 1.2";
constexpr std::size_t dyna_header_lines = 64;

/// A line of the header: KEY: VALUE, with a key in capitals. Longer lines than any header has would fill messages.
std::optional<std::pair<std::string_view, std::string_view>> key_and_value(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || colon == 0 || line.size() > 1000) return std::nullopt;
  const std::string_view key = line.substr(0, colon);
  const bool is_key = std::ranges::all_of(
      key, [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '/' || c == '^'; });
  if (!is_key) return std::nullopt;
  return {{key, trimmed(line.substr(colon + 1))}};
}

void check_dyna(const TextFile& file, const HeaderKeys& keys, std::size_t lines) {
  if (keys.find("HEADER_FORMAT") == format_of_fixed_length && lines != dyna_header_lines)
    refuse_file(file.path, "a header of format DYNA 1.2 has 64 lines, but this one has " + std::to_string(lines) +
                               ". The file was edited or cut; fetch it again.");
  const std::string type = keys.value("DATA_TYPE"), capitals = upper_case(type);
  if (capitals.find("ACCELERATION") == std::string::npos || capitals.find("SPECTRUM") != std::string::npos)
    throw NotARecord{file.path.string() + ": the header says DATA_TYPE: " + type +
                     ". Only histories of ACCELERATION are read; take the file of accelerations."};
  if (const std::string unit = keys.value("UNITS"); upper_case(unit) != "CM/S^2")
    refuse_file(file.path, "the header says UNITS: " + unit +
                               ". Only cm/s^2 is read; take the file of accelerations, or convert it.");
}

/// "20190728_160919.870" or "14/11/2010 23:09:19.300".
std::optional<double> dyna_start(std::string text) {
  if (text.size() > 14 && text[8] == '_')
    text = text.substr(0, 4) + " " + text.substr(4, 2) + " " + text.substr(6, 2) + " " + text.substr(9, 2) + " " +
           text.substr(11, 2) + " " + text.substr(13);
  std::vector<double> date = numbers_in(text);
  if (date.size() == 6 && date[0] <= 31.0) std::swap(date[0], date[2]);
  return utc_seconds(date);
}

}  // namespace

bool is_dyna(const TextFile& file) { return file.text.starts_with("EVENT_NAME:"); }

std::vector<RecordChannel> read_dyna(const TextFile& file) {
  RecordChannel channel{.format = "ESM", .unit = "cm/s^2"};
  HeaderKeys keys{file};
  std::size_t header_lines = 0;
  LineReader lines{file};
  for (std::string_view line; lines.next(line);) {
    line = trimmed(line);
    if (channel.samples.empty())
      if (const auto entry = key_and_value(line)) {
        ++header_lines;
        keys.set(entry->first, entry->second);
        if (!entry->second.empty()) channel.notes.emplace_back(line);
        continue;
      }
    if (line.empty()) continue;
    const ScannedNumber number = parse_number(line);
    if (number.problem)
      lines.refuse(quoted(line) + " " + number.problem + ". Behind the header every line holds one acceleration.");
    channel.samples.push_back(0.01 * number.value);
  }
  check_dyna(file, keys, header_lines);
  const std::size_t count = keys.count("NDATA");
  if (channel.samples.size() != count)
    refuse_file(file.path, "the header announces NDATA: " + std::to_string(count) + " values, but the file holds " +
                               std::to_string(channel.samples.size()) +
                               ". The file is damaged or was cut; fetch it again.");
  channel.step = keys.positive("SAMPLING_INTERVAL_S", "s");
  if (!keys.find("DURATION_S").empty())
    if (const double length = static_cast<double>(count) * channel.step, stated = keys.positive("DURATION_S", "s");
        std::abs(length - stated) > 1.1 * channel.step + 0.01)
      refuse_file(file.path, std::to_string(count) + " values every " + to_text(channel.step) + " s make " +
                                 to_text(length) + " s, but DURATION_S is " + to_text(stated) + ".");
  channel.network = keys.find("NETWORK");
  channel.station = keys.find("STATION_CODE");
  channel.location = keys.find("LOCATION");
  channel.event = keys.find("EVENT_ID");
  channel.start = dyna_start(keys.find("DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS"));
  if (upper_case(keys.find("DATA_TYPE")).starts_with("UNPROCESSED")) channel.level = RecordLevel::uncorrected;
  set_component(channel, keys.find("STREAM"));
  state_peak(channel, keys.find("PGA_CM/S^2"), 0.01);
  return {channel};
}

}  // namespace moat
