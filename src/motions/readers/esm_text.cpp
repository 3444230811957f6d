#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/text_file.hpp"
#include "motions/readers/record_formats.hpp"

namespace moat {
namespace {

constexpr std::string_view format_of_fixed_length = "DYNA 1.2";
constexpr std::size_t esm_header_lines = 64;
constexpr double centimetre = 0.01;

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

class Header {
 public:
  explicit Header(const TextFile& file) : file_{&file} {}

  bool take(std::string_view line) {
    const auto entry = key_and_value(line);
    if (!entry) return false;
    ++lines_;
    values_.insert_or_assign(std::string{entry->first}, std::string{entry->second});
    if (!entry->second.empty()) notes_.emplace_back(line);
    return true;
  }
  void check() const {
    const auto format = values_.find("HEADER_FORMAT");
    if (format != values_.end() && format->second == format_of_fixed_length && lines_ != esm_header_lines)
      refuse_file(file_->path, "a header of format DYNA 1.2 has 64 lines, but this one has " + std::to_string(lines_) +
                                   ". The file was edited or cut; fetch it again.");
    if (upper_case(value("UNITS")) != "CM/S^2")
      refuse_file(file_->path, "the header says UNITS: " + value("UNITS") +
                                   ". Only cm/s^2 is read; take the file of accelerations, or convert it.");
    const std::string type = upper_case(value("DATA_TYPE"));
    if (type.find("ACCELERATION") == std::string::npos || type.find("SPECTRUM") != std::string::npos)
      refuse_file(file_->path,
                  "the header says DATA_TYPE: " + value("DATA_TYPE") + ". Only histories of ACCELERATION are read.");
  }
  [[nodiscard]] double time_step() const {
    const ScannedNumber number = parse_number(value("SAMPLING_INTERVAL_S"));
    if (number.problem || !(number.value > 0.0))
      refuse_file(file_->path, "SAMPLING_INTERVAL_S: " + value("SAMPLING_INTERVAL_S") +
                                   " in the header is not allowed; it must be a number > 0 s.");
    return number.value;
  }
  [[nodiscard]] std::size_t count() const {
    const std::string text = value("NDATA");
    std::string_view rest = text;
    const std::size_t count = take_whole_number(rest).value_or(0);
    if (!rest.empty() || count < 2)
      refuse_file(file_->path, "NDATA: " + text + " in the header is not allowed; it must be a whole number >= 2.");
    return count;
  }
  [[nodiscard]] std::vector<std::string> notes() const { return notes_; }

 private:
  [[nodiscard]] std::string value(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end() || found->second.empty())
      refuse_file(file_->path,
                  "the header does not give " + key + ". Fetch the file again, or add the line \"" + key + ": ...\".");
    return found->second;
  }

  const TextFile* file_;
  std::size_t lines_ = 0;
  std::map<std::string, std::string> values_;
  std::vector<std::string> notes_;
};

}  // namespace

bool is_esm(const TextFile& file) { return file.text.starts_with("EVENT_NAME:"); }

GroundMotion parse_esm(const TextFile& file) {
  Header header{file};
  std::vector<double> samples;
  LineReader lines{file};
  for (std::string_view line; lines.next(line);) {
    line = trimmed(line);
    if (samples.empty() && header.take(line)) continue;
    if (line.empty()) continue;
    const ScannedNumber number = parse_number(line);
    if (number.problem)
      lines.refuse(quoted(line) + " " + number.problem + ". Behind the header every line holds one acceleration.");
    samples.push_back(centimetre * number.value);
  }
  header.check();
  if (samples.size() != header.count())
    refuse_file(file.path, "the header announces NDATA: " + std::to_string(header.count()) +
                               " values, but the file holds " + std::to_string(samples.size()) +
                               ". The file is damaged or was cut; fetch it again.");
  return GroundMotion{file.path.stem().string(), header.time_step(), std::move(samples), header.notes(), file_of(file)};
}

GroundMotion read_esm(const std::filesystem::path& path) { return parse_esm(read_text_file(path)); }

}  // namespace moat
