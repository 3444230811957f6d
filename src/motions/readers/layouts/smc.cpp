#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/check.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr std::size_t smc_text_lines = 11;
constexpr FortranFormat smc_integers{8, 10, true}, smc_reals{5, 15, false}, smc_values{8, 10, false};

}  // namespace

bool is_smc(const TextFile& file) {
  LineReader lines{file};
  std::string_view line;
  bool begins = false;
  while (lines.line_number() < smc_text_lines && lines.next(line)) {
    if (lines.line_number() == 1)
      begins = trimmed(line) == "2 CORRECTED ACCELEROGRAM" || trimmed(line) == "1 UNCORRECTED ACCELEROGRAM";
    if (lines.line_number() == 2 && !line.starts_with('*')) return false;
  }
  return begins && line.starts_with('*');
}

std::vector<RecordChannel> read_smc(const TextFile& file) {
  RecordLines lines{file};
  RecordChannel channel{.format = "SMC", .network = "USGS", .unit = "cm/s^2"};
  channel.notes = lines.text(smc_text_lines, "the last of its 11 lines of text");
  if (channel.notes[0].find("UNCORRECTED") != std::string::npos) {
    channel.level = RecordLevel::uncorrected;
  }
  const std::vector<double> integers = lines.numbers(48, smc_integers, "the header of whole numbers"),
                            reals = lines.numbers(50, smc_reals, "the header of numbers");
  const auto integer = [&](std::size_t number) {
    const double value = integers[number - 1];
    return value == integers[0] ? std::nullopt : std::optional{value};
  };
  const auto real = [&](std::size_t number) {
    const double value = reals[number - 1];
    return std::abs(value - reals[0]) <= 1e-6 * std::abs(reals[0]) ? std::nullopt : std::optional{value};
  };
  if (integer(18) == 1.0) lines.refuse("value 18 of the header marks the record as doubtful; take another one.");
  const double rate = real(2).value_or(0.0), count = integer(17).value_or(0.0);
  if (!(rate > 0.0))
    throw NotARecord{
        file.path.string() +
        ": the header states no rate: pairs of time and value, and times are not even. Resample the record "
        "to a constant step, as two columns."};
  if (!(count >= 2.0 && count <= 1e9))
    lines.refuse("the number of values, 17 of the header, is " + to_text(count) + "; it must be >= 2 and <= 1e9.");
  channel.step = 1.0 / rate;
  // Day of the year; seconds may be unknown.
  if (const auto year = integer(2), day = integer(3), hour = integer(4), minute = integer(5), second = integer(6);
      year && day && hour && minute && second)
    if (const auto new_year = utc_seconds({*year, 1.0, 1.0, 0.0, 0.0, 0.0}))
      channel.start = *new_year + 86400.0 * (*day - 1.0) + 3600.0 * *hour + 60.0 * *minute + *second +
                      1e-3 * integer(7).value_or(0.0);
  channel.event = trimmed(channel.notes[3]);
  // "station = San Francisco, 1295    component=    360"
  std::string_view station = channel.notes[5];
  const std::size_t place = std::min(upper_case(station).find("COMPONENT"), station.size());
  std::string_view word = station.substr(place);
  station = station.substr(0, place);
  take_behind(station, "=");
  take_behind(word, "=");
  channel.station = trimmed(station);
  const std::optional<double> angle = integer(13);
  const std::string azimuth = integer(14) ? to_text(*integer(14)) : "";
  if (angle && *angle != 0.0 && *angle != 90.0 && *angle != 180.0)
    lines.refuse("the component is inclined by " + to_text(*angle) +
                 " deg (value 13 of the header); only 0, 90 and 180 deg are read.");
  // A component whose angle is not known may be vertical: its name decides.
  const std::optional<ComponentWord> named = component_word(word);
  if (!angle)
    set_component(channel, word);
  else if (*angle != 90.0)
    set_component(channel, *angle == 0.0 ? "UP" : "DOWN");
  else if (!set_component(channel, azimuth))
    set_component(channel, word);
  if (named && !channel.component.empty() &&
      (named->vertical != channel.vertical ||
       (named->azimuth && channel.azimuth && *named->azimuth != *channel.azimuth)))
    channel.warnings.push_back("component " + quoted(trimmed(word)) + " in the text, " +
                               moat::quoted(channel.component) + " in the header: header taken");
  if (const auto large = real(30), small = real(32); large && small)
    state_peak(channel, std::max(std::abs(*large), std::abs(*small)), 0.01);
  for (double comments = integer(16).value_or(0.0); comments > 0.0; --comments)
    if (!lines.line("the last comment").starts_with('|')) lines.refuse("expected a comment with \"|\" in front.");
  set_samples(channel, lines.numbers(static_cast<std::size_t>(count), smc_values, "acceleration"));
  if (std::string_view more; lines.next_filled(more))
    lines.refuse("text follows the " + to_text(count) + " values that the header announces: " + quoted(more) + ".");
  return {channel};
}

}  // namespace moat
