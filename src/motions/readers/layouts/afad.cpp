#include <algorithm>
#include <array>

#include "base/check.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr std::size_t afad_header_lines = 18, afad_columns = 3;

}  // namespace

bool is_afad(const TextFile& file) {
  return file.text.substr(0, file.text.find('\n')).find("STRONG GROUND MOTION RECORDS OF TURKIYE") != std::string::npos;
}

std::vector<RecordChannel> read_afad(const TextFile& file) {
  RecordLines lines{file};
  const std::vector<std::string> header = lines.text(afad_header_lines, "the last of its 18 header lines");
  HeaderKeys keys{file};
  for (const std::string_view line : header)
    if (const std::size_t colon = line.find(':'); colon != std::string_view::npos)
      keys.set(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
  const std::size_t count = keys.count("NUMBER OF DATA");
  std::vector<double> time = numbers_in(keys.find("RECORD TIME"));
  if (time.size() == 6) std::swap(time[0], time[2]);  // day, month, year
  const std::string peaks = keys.find("RAW PGA VALUES (GAL)");
  std::vector<RecordChannel> channels;
  std::string_view order = header.back();
  for (std::size_t i = 0; i < afad_columns; ++i) {
    order = without_leading_blanks(order);
    const std::string name{order.substr(0, order.find_first_of(" \t"))};
    order.remove_prefix(name.size());
    RecordChannel& channel = channels.emplace_back(RecordChannel{.format = "AFAD", .network = "TK", .unit = "gal"});
    if (!set_component(channel, name))
      lines.refuse("expected the names of the columns, such as N-S E-W U-D, but found " + quoted(header.back()) + ".");
    channel.station = keys.value("STATION ID");
    channel.event = keys.find("EARTHQUAKE DATE");
    channel.step = keys.positive("SAMPLING INTERVAL (SEC)", "s");
    channel.start = utc_seconds(time);
    channel.notes = header;
    channel.samples.reserve(std::min(count, file.text.size()));
    if (const std::size_t at = peaks.find("(" + name + ")"); at != std::string::npos)
      state_peak(channel, std::string_view{peaks}.substr(at + name.size() + 2), 0.01);
  }
  for (std::string_view line; lines.next_filled(line);) {
    const std::string_view whole = line;
    for (RecordChannel& channel : channels) {
      line = without_leading_blanks(line);
      const std::string_view word = line.substr(0, line.find_first_of(" \t"));
      const ScannedNumber number = parse_number(word);
      if (number.problem)
        lines.refuse("expected three numbers, but found " + quoted(word) + " in " + quoted(whole) + ".");
      channel.samples.push_back(0.01 * number.value);
      line.remove_prefix(word.size());
    }
    if (!trimmed(line).empty()) lines.refuse("expected three numbers, but found " + quoted(whole) + ".");
  }
  if (channels[0].samples.size() != count)
    refuse_file(file.path, "the header announces NUMBER OF DATA: " + std::to_string(count) + ", but the file holds " +
                               std::to_string(channels[0].samples.size()) + " rows. It was cut; fetch it again.");
  return channels;
}

}  // namespace moat
