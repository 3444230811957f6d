#include <algorithm>
#include <array>
#include <cctype>

#include "base/check.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr std::size_t header_lines = 4;
constexpr std::size_t units_line = 3;
constexpr std::size_t count_line = 4;

struct PeerSampling {
  std::size_t count = 0;
  double time_step = 0.0;
};

std::optional<std::size_t> take_count(std::string_view& text) {
  const std::optional<std::size_t> count = take_whole_number(text);
  // "4000." or "4000E2" is not a count.
  if (!text.empty() && std::string_view{" \t,"}.find(text[0]) == std::string_view::npos) return std::nullopt;
  return count;
}

std::optional<double> take_number(std::string_view& text) {
  text = without_leading_blanks(text);
  const ScannedNumber number = scan_number(text);
  if (number.problem) return std::nullopt;
  text.remove_prefix(number.length);
  if (!text.empty() && std::string_view{" \t,sS"}.find(text[0]) == std::string_view::npos) return std::nullopt;
  return number.value;
}

bool take_key(std::string_view& text, std::string_view word) { return take_behind(text, word) && take(text, "="); }

/// NPTS=   5600, DT=   .0050 SEC
std::optional<PeerSampling> sampling_from_keys(std::string_view line) {
  if (!take_key(line, "NPTS")) return std::nullopt;
  const std::optional<std::size_t> count = take_count(line);
  if (!count || !take_key(line, "DT")) return std::nullopt;
  const std::optional<double> time_step = take_number(line);
  if (!time_step) return std::nullopt;
  // A word after the time step must be its unit, and seconds; numbers belong to the filter and are of no interest.
  line = without_leading_blanks(line);
  const auto word_end = std::find_if(line.begin(), line.end(), [](unsigned char c) { return !std::isalpha(c); });
  const std::string_view word{line.begin(), word_end};
  constexpr std::array<std::string_view, 5> seconds{"", "S", "SEC", "SECS", "SECONDS"};
  if (std::find(seconds.begin(), seconds.end(), word) == seconds.end()) return std::nullopt;
  return PeerSampling{*count, *time_step};
}

/// 4000    0.0050    NPTS, DT
std::optional<PeerSampling> sampling_before_words(std::string_view line) {
  const std::optional<std::size_t> count = take_count(line);
  if (!count) return std::nullopt;
  const std::optional<double> time_step = take_number(line);
  if (!time_step) return std::nullopt;
  if (!take(line, "NPTS") || !take_behind(line, "DT")) return std::nullopt;
  return PeerSampling{*count, *time_step};
}

/// "... UNITS OF G", possibly followed by punctuation and other remarks ("UNITS OF G. FILTER POINTS: ...").
bool says_units_of_g(std::string_view line) {
  const std::string capitals = upper_case(trimmed(line));
  std::string_view unit = capitals;
  if (!take_behind(unit, "UNITS OF") || !take(unit, "G")) return false;
  return unit.empty() || std::string_view{".,;)"}.find(unit[0]) != std::string_view::npos;
}

void require_units_of_g(const LineReader& lines, std::string_view line) {
  if (says_units_of_g(line)) return;
  lines.refuse("this line of a PEER AT2 file must say \"ACCELERATION TIME SERIES IN UNITS OF G\", but it says " +
               quoted(trimmed(line)) +
               ". Only accelerations in g are read; convert the file, or save it as two columns.");
}

PeerSampling parse_sampling(const LineReader& lines, std::string_view line) {
  const std::string capitals = upper_case(line);
  std::optional<PeerSampling> sampling = sampling_from_keys(capitals);
  if (!sampling) sampling = sampling_before_words(capitals);
  if (!sampling) {
    lines.refuse(
        "expected the number of values and the time step in s, as \"NPTS= 5600, DT= .0050 SEC\" or "
        "\"5600 0.0050 NPTS, DT\", but found " +
        quoted(trimmed(line)) + ".");
  }
  if (sampling->count < 2)
    lines.refuse("NPTS = " + std::to_string(sampling->count) + " is not allowed; it must be >= 2.");
  if (!(sampling->time_step > 0.0))
    lines.refuse("DT = " + to_text(sampling->time_step) + " s is not allowed; it must be > 0 s.");
  return *sampling;
}

/// Appends the values of one line.
void append_values(const LineReader& lines, std::string_view line, std::vector<double>& values) {
  for (line = trimmed(line); !line.empty(); line = without_leading_blanks(line)) {
    const ScannedNumber number = scan_number(line);
    // Looked for where it is shown alone: without blanks it is the whole line.
    const auto word = [&] { return quoted(line.substr(0, line.find_first_of(" \t"))); };
    if (number.problem) {
      lines.refuse(word() + " " + number.problem + ". Only accelerations in g may follow the header.");
    }
    const bool ends_here = number.length == line.size() || line[number.length] == ' ' || line[number.length] == '\t';
    const bool sign_after_exponent =
        !ends_here && number.has_exponent && (line[number.length] == '-' || line[number.length] == '+');
    if (!ends_here && !sign_after_exponent) {
      lines.refuse(word() +
                   " is not one number, and where one ends and the next begins is not certain. Separate the values "
                   "with blanks.");
    }
    values.push_back(number.value);
    line.remove_prefix(number.length);
  }
}

bool has_peer_at2_header(const TextFile& file) {
  LineReader lines{file};
  std::string_view line;
  while (lines.line_number() < header_lines && lines.next(line)) {
    // A comment of a two-column file may mention units.
    if (line.starts_with('#') || line.starts_with('%')) return false;
    const std::string capitals = upper_case(line);
    if (lines.line_number() == units_line && capitals.find("UNITS OF") != std::string::npos) return true;
    if (lines.line_number() == count_line && capitals.find("NPTS") != std::string::npos) return true;
  }
  return false;
}

}  // namespace

bool is_peer_at2(const TextFile& file) {
  return has_peer_at2_header(file) || (upper_case(file.path.extension().string()) == ".AT2" && !is_plain_text(file));
}

std::vector<RecordChannel> read_peer_at2(const TextFile& file) {
  const std::filesystem::path& path = file.path;
  LineReader lines{file};
  std::string_view line;
  RecordChannel channel{.format = "PEER AT2", .unit = "g"};
  std::vector<std::string>& header = channel.notes;
  while (header.size() < header_lines && lines.next(line)) {
    header.emplace_back(trimmed(line));
    if (header.size() == units_line) require_units_of_g(lines, line);
  }
  if (header.size() < header_lines)
    refuse_file(path, "a PEER AT2 file begins with " + std::to_string(header_lines) +
                          " header lines, but this file has only " + std::to_string(header.size()) + ".");
  const PeerSampling sampling = parse_sampling(lines, line);
  // A remark may follow the component: "230 (USGS STATION 5028)".
  const std::string& second = header[1];
  if (const std::size_t comma = second.rfind(','); comma != std::string::npos)
    if (set_component(channel, second.substr(comma + 1, second.find('(', comma) - comma - 1))) {
      const std::size_t station = second.rfind(',', comma - 1);
      const bool has_event = comma > 0 && station != std::string::npos;
      channel.station =
          trimmed(std::string_view{second}.substr(has_event ? station + 1 : 0, comma - (has_event ? station + 1 : 0)));
      if (has_event) channel.event = second.substr(0, station);
    }
  channel.step = sampling.time_step;

  std::vector<double> values;
  // A wrong count in the header must not reserve more than the file can hold.
  values.reserve(std::min(sampling.count, file.text.size() / 2));
  while (lines.next(line)) append_values(lines, line, values);
  if (values.size() != sampling.count) {
    refuse_file(path, "the header announces NPTS = " + std::to_string(sampling.count) + " values, but the file holds " +
                          std::to_string(values.size()) + ". The file is damaged or was cut; fetch it again.");
  }
  set_samples(channel, values);
  return {channel};
}

}  // namespace moat
