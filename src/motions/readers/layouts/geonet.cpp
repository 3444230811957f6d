#include <cmath>

#include "base/check.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr std::size_t geonet_text_lines = 16, geonet_per_line = 10;
// Numbers of values in the headers, from 0.
constexpr std::size_t counts_value = 33, in_front_value = 21, seconds_value = 23, step_value = 25;
constexpr FortranFormat geonet_integers{geonet_per_line, 8, true}, geonet_reals{geonet_per_line, 8, false};

}  // namespace

bool is_geonet(const TextFile& file) {
  const std::string_view line = std::string_view{file.text}.substr(0, file.text.find('\n'));
  return (line.starts_with("Corrected accelerogram") || line.starts_with("Uncorrected accelerogram")) &&
         line.find("GNS Science") != std::string_view::npos;
}

std::vector<RecordChannel> read_geonet(const TextFile& file) {
  RecordLines lines{file};
  std::vector<RecordChannel> channels;
  for (std::string_view line; lines.next_filled(line);) {
    RecordChannel channel{.format = "GeoNet", .network = "NZ", .unit = "mm/s^2"};
    const std::string title{trimmed(line)};
    if (!line.starts_with("Corrected") && !line.starts_with("Uncorrected"))
      lines.refuse("expected the beginning of a channel, \"Corrected accelerogram\", but found " + quoted(line) + ".");
    if (line.starts_with("Uncorrected")) {
      channel.level = RecordLevel::uncorrected;
    }
    channel.notes = lines.text(geonet_text_lines - 1, "the last of its 16 lines of text");
    channel.notes.insert(channel.notes.begin(), title);
    std::string_view site = channel.notes[1], component = channel.notes[12];
    if (!take(site, "Site") || !take(component, "Component"))
      lines.refuse("lines 2 and 13 of the channel must say Site and Component.");
    site = trimmed(site);
    channel.station = site.substr(0, site.find(' '));
    component = trimmed(component);
    if (!set_component(channel, component.substr(0, component.find(' '))))
      lines.refuse("the component " + quoted(component) + " is none such as N80W or Up.");
    channel.event = channel.notes[5].substr(0, channel.notes[5].find("  "));
    state_peak(channel, channel.notes[13], 1e-3);

    const std::vector<double> integers = lines.numbers(40, geonet_integers, "the header of whole numbers"),
                              reals = lines.numbers(60, geonet_reals, "the header of numbers");
    channel.step = reals[step_value];
    if (!(channel.step > 0.0))
      lines.refuse("the step, number 26 of the header, is " + to_text(channel.step) + " s; it must be > 0 s.");
    // Files count their length with and without the interval behind the last sample.
    if (const double length = integers[counts_value] * channel.step;
        reals[seconds_value] > 0.0 && std::abs(reals[seconds_value] - length) > 1.1 * channel.step + 0.01)
      lines.refuse(to_text(integers[counts_value]) + " accelerations every " + to_text(channel.step) + " s make " +
                   to_text(length) + " s, but number 24 of the header is " + to_text(reals[seconds_value]) + " s.");
    // The first values are the origin of the earthquake. Zeros in front of a corrected record are not in the buffer.
    if (const auto start =
            utc_seconds({integers[8], integers[9], integers[18], integers[19], integers[38], 1e-3 * integers[39]}))
      channel.start = *start - reals[in_front_value];
    for (std::size_t part = 0; part < 3; ++part) {
      const double count = integers[counts_value + part];
      if (!(count >= 0.0 && count <= 1e9))
        lines.refuse("a number of values is " + to_text(count) + "; it must be >= 0 and <= 1e9.");
      if (part == 0)
        set_samples(channel, lines.numbers(static_cast<std::size_t>(count), geonet_reals, "acceleration"));
      else
        lines.skip(static_cast<std::size_t>(std::ceil(count / geonet_per_line)),
                   "the last value of velocity and displacement");
    }
    channels.push_back(std::move(channel));
  }
  return channels;
}

}  // namespace moat
