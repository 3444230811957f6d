#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {

bool is_cwa(const TextFile& file) {
  const std::string beginning = upper_case(std::string_view{file.text}.substr(0, 4000));
  return beginning.starts_with("#EARTHQUAKE INFORMATION") ||
         (beginning.starts_with('#') && beginning.find("\n#DATASEQUENCE") != std::string::npos &&
          beginning.find("\n#DATA:") != std::string::npos);
}

std::vector<RecordChannel> read_cwa(const TextFile& file) {
  RecordLines lines{file};
  HeaderKeys keys{file};
  std::vector<std::string> header;
  while (keys.find("#DATA").empty()) {
    const std::string_view line = trimmed(lines.line("the line \"#Data: 4F10.3\""));
    if (line.empty()) continue;
    if (!line.starts_with('#'))
      lines.refuse("expected a line of the header, \"#Data: 4F10.3\" at its end, but found " + quoted(line) + ".");
    header.emplace_back(line);
    // "#AmplitudeMAX. U: 0.658~ -0.837" has its colon behind the letter, "#StartTime(GMT+08): 2018/..." its first one.
    if (const std::size_t colon = line.find(':'); colon != std::string_view::npos)
      keys.set(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
  }
  const std::optional<FortranFormat> format = fortran_format(keys.find("#DATA"));
  if (!format) lines.refuse("expected a Fortran format such as 4F10.3, but found " + quoted(keys.find("#DATA")) + ".");
  const std::string unit = keys.value("#AMPLITUDEUNIT");
  if (upper_case(unit.substr(0, unit.find_first_of(" .,;("))) != "GAL")
    refuse_file(file.path, "the header says #AmplitudeUnit: " + unit + ". Only gal is read; convert the file.");

  std::vector<RecordChannel> channels;
  std::vector<std::string> names;
  const std::string sequence = upper_case(keys.value("#DATASEQUENCE"));
  std::string_view rest = sequence;
  if (!take(rest, "TIME")) refuse_file(file.path, "#DataSequence: " + sequence + " does not begin with Time.");
  while (!trimmed(rest).empty()) {
    const std::string& name = names.emplace_back(trimmed(rest.substr(0, rest.find('('))));
    const bool named = take_behind(rest, "(") && rest.size() > 1 && rest[1] == ')';
    const char sign = named ? rest[0] : ' ';
    if (named) rest.remove_prefix(2);
    take(rest, ";");
    RecordChannel& channel = channels.emplace_back(RecordChannel{.format = "CWA", .network = "TW", .unit = "gal"});
    if (!named || (sign != '+' && sign != '-') || !set_component(channel, name))
      refuse_file(file.path, "#DataSequence: " + sequence + " is not of the form \"Time U(+); N(+); E(+)\".");
    if (sign == '-' && channel.azimuth) channel.azimuth = std::fmod(*channel.azimuth + 180.0, 360.0);
    if (sign == '-' && channel.vertical) channel.component = "DOWN";
  }
  if (channels.empty() || channels.size() + 1 != format->per_line)
    refuse_file(file.path, "#DataSequence and #Data differ in the number of columns.");

  const double step = 1.0 / keys.positive("#SAMPLERATE(HZ)", "Hz");
  std::vector<PrintedTime> times;
  std::vector<std::vector<double>> values(channels.size());
  for (std::string_view line; lines.next_filled(line);) {
    line = line.substr(0, line.find_last_not_of(" \t") + 1);
    if ((line.size() + format->width - 1) / format->width != format->per_line)
      lines.refuse("expected " + std::to_string(format->per_line) + " columns of " + std::to_string(format->width) +
                   " characters, but found " + quoted(line) + ".");
    for (std::size_t i = 0; i < format->per_line; ++i) {
      const std::string_view field = trimmed(line.substr(i * format->width, format->width));
      const ScannedNumber number = parse_number(field);
      if (number.problem) lines.refuse(quoted(field) + " " + number.problem + ".");
      if (i == 0)
        times.push_back({*first_number(field), lines.line_number()});
      else
        values[i - 1].push_back(number.value);
    }
  }
  if (times.size() < 2)
    refuse_file(file.path, "there are fewer than two rows of data. The file was cut; fetch it again.");
  if (const std::string length = keys.find("#RECORDLENGTH(SEC)"); !length.empty())
    if (const double expected = keys.positive("#RECORDLENGTH(SEC)", "s") / step;
        std::abs(expected - static_cast<double>(times.size())) > 1.0)
      refuse_file(file.path, "#RecordLength(sec): " + length + " makes " + to_text(expected) +
                                 " rows, but the file holds " + std::to_string(times.size()) + ". Fetch it again.");
  const double even = even_step(file.path, times, step);
  std::optional<double> start = utc_seconds(numbers_in(keys.find("#STARTTIME(GMT+08)")));
  if (start) *start -= 8.0 * 3600.0;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    RecordChannel& channel = channels[i];
    channel.station = keys.value("#STATIONCODE");
    // Older files say neither the origin nor the zone of their time.
    channel.event = keys.find("#ORIGIN TIME(GMT+08)") + keys.find("#STARTTIME");
    channel.step = even;
    channel.start = start;
    channel.notes = header;
    set_samples(channel, values[i]);
    const std::string extremes = keys.find("#AMPLITUDEMAX. " + names[i]);
    const std::string_view least = std::string_view{extremes}.substr(std::min(extremes.find('~') + 1, extremes.size()));
    const auto one = first_number(extremes), two = first_number(least);
    if (one && two) state_peak(channel, std::abs(one->value) > std::abs(two->value) ? extremes : least, 0.01);
  }
  return channels;
}

}  // namespace moat
