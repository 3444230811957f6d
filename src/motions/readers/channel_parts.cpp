#include "motions/readers/channel_parts.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "base/check.hpp"
#include "base/text/text_file.hpp"
#include "base/units.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr double full_turn = 360.0;

bool is_figure(char c) { return c >= '0' && c <= '9'; }

/// Degrees clockwise from north: "90", "360 DEG".
std::optional<double> azimuth_in_degrees(std::string_view word) {
  const ScannedNumber number = scan_number(word);
  const std::string_view rest = trimmed(word.substr(number.length));
  if (number.problem || !is_figure(word[0]) || number.has_exponent || number.value > full_turn ||
      (!rest.empty() && rest != "DEG" && rest != "DEG." && rest != "DEGREES"))
    return std::nullopt;
  return std::fmod(number.value, full_turn);
}

/// N80W: from north or south towards west or east.
std::optional<double> azimuth_in_quadrant(std::string_view word) {
  const char from = word.front(), to = word.back();
  if (word.size() < 3 || (from != 'N' && from != 'S') || (to != 'E' && to != 'W')) return std::nullopt;
  const std::optional<double> turn = azimuth_in_degrees(trimmed(word.substr(1, word.size() - 2)));
  if (!turn || *turn > 90.0) return std::nullopt;
  const double start = from == 'N' ? 0.0 : 180.0;
  return std::fmod(start + ((from == 'N') == (to == 'E') ? *turn : full_turn - *turn), full_turn);
}

/// Codes of accelerometers, such as HNE: band, N, L or G, orientation.
bool is_seed_code(std::string_view word) {
  return word.size() == 3 && std::string_view{"BCEHLS"}.find(word[0]) != std::string_view::npos &&
         std::string_view{"NLG"}.find(word[1]) != std::string_view::npos &&
         std::string_view{"ZNE123"}.find(word[2]) != std::string_view::npos;
}

}  // namespace

std::optional<double> acceleration_unit(std::string_view name) {
  static const std::map<std::string, double> units{{"G", standard_gravity},
                                                   {"MG", 1e-3 * standard_gravity},
                                                   {"G/10", 0.1 * standard_gravity},
                                                   {"GAL", 0.01},
                                                   {"CM", 0.01},
                                                   {"MM", 1e-3},
                                                   {"IN", 0.0254},
                                                   {"FT", 0.3048},
                                                   {"M", 1.0}};
  std::string unit;
  for (const char letter : upper_case(name))
    if (letter != '^' && letter != ' ') unit += letter;
  for (const char* per_second : {"/S2", "/S/S", "/SEC/SEC", "/SEC2", "/SEC**2", "/S**2"})
    if (unit.ends_with(per_second)) {
      unit.resize(unit.size() - std::string_view{per_second}.size());
      if (unit == "G" || unit == "MG" || unit == "GAL") return std::nullopt;
      const auto length = units.find(unit);
      return length == units.end() ? std::nullopt : std::optional{length->second};
    }
  const auto found = units.find(unit);
  const bool is_length = unit == "CM" || unit == "MM" || unit == "IN" || unit == "FT" || unit == "M";
  return found == units.end() || is_length ? std::nullopt : std::optional{found->second};
}

std::optional<ComponentWord> component_word(std::string_view text) {
  static const std::set<std::string_view> up{"UP", "VER", "VERT", "VERTICAL", "VRT", "V", "Z", "U", "UD", "U-D"},
      down{"DOWN", "DWN", "DN"}, unknown{"H1", "H2", "L", "T", "R", "FN", "FP", "LONG", "TRAN", "X", "Y"};
  static const std::map<std::string_view, double> azimuths{
      {"N", 0.0},   {"NS", 0.0},  {"N-S", 0.0},   {"E", 90.0},    {"EW", 90.0},     {"E-W", 90.0},
      {"S", 180.0}, {"W", 270.0}, {"NORTH", 0.0}, {"EAST", 90.0}, {"SOUTH", 180.0}, {"WEST", 270.0}};
  const std::string capitals = upper_case(trimmed(text));
  if (capitals.empty()) return std::nullopt;
  std::string_view word = capitals;
  if (is_seed_code(word)) {
    const char last = word[2];
    if (last == '1' || last == '2') return ComponentWord{};
    word = last == '3' ? "Z" : word.substr(2);
  }
  if (up.contains(word)) return ComponentWord{.vertical = true};
  if (down.contains(word)) return ComponentWord{.vertical = true, .down = true};
  if (unknown.contains(word)) return ComponentWord{};
  if (const auto found = azimuths.find(word); found != azimuths.end()) return ComponentWord{.azimuth = found->second};
  for (const auto& azimuth : {azimuth_in_degrees(word), azimuth_in_quadrant(word)})
    if (azimuth) return ComponentWord{.azimuth = azimuth};
  return std::nullopt;
}

DividedName divided_name(const std::filesystem::path& file) {
  std::string name = file.stem().string(), ending = upper_case(file.extension().string());
  // Endings of K-NET and KiK-net; 1 and 2 count boreholes.
  if (ending.ends_with('1') || ending.ends_with('2')) ending.pop_back();
  if (ending == ".EW" || ending == ".NS" || ending == ".UD") return {name, ending.substr(1)};
  const std::string capitals = upper_case(name);
  const std::size_t size = name.size(), separator = name.find_last_of("-_. ");
  std::size_t length = separator == std::string::npos ? 0 : size - separator - 1;
  const auto has_figures_only = [](std::string_view word) { return std::ranges::all_of(word, is_figure); };
  // Numbers of fewer digits may count records.
  const bool ends_in_azimuth = size > 3 && has_figures_only(name.substr(size - 3)) && !is_figure(name[size - 4]);
  if (ends_in_azimuth) length = 3;
  const bool ends_in_up = size > 2 && name.ends_with("UP") &&
                          (is_figure(name[size - 3]) || std::isupper(static_cast<unsigned char>(name[size - 3])) != 0);
  if (ends_in_up) length = 2;
  const std::string word = capitals.substr(size - length);
  if (!component_word(word) || word == "U" || word == "X" || word == "Y" || (is_figure(word[0]) && !ends_in_azimuth))
    return {name, ""};
  name.resize(size - length);
  return {name.substr(0, name.find_last_not_of("-_. ") + 1), word};
}

bool set_component(RecordChannel& channel, std::string_view word, const std::string& source) {
  const std::optional<ComponentWord> meaning = component_word(word);
  if (!meaning) return false;
  channel.component = trimmed(word);
  channel.source = source;
  channel.azimuth = meaning->azimuth;
  channel.vertical = meaning->vertical;
  if (meaning->down)
    for (double& sample : channel.samples) sample = -sample;
  return true;
}

void set_samples(RecordChannel& channel, const std::vector<double>& values) {
  const std::optional<ComponentWord> meaning = component_word(channel.component);
  const double unit = acceleration_unit(channel.unit).value() * (meaning && meaning->down ? -1.0 : 1.0);
  channel.samples.reserve(values.size());
  for (const double value : values) channel.samples.push_back(unit * value);
}

void state_peak(RecordChannel& channel, std::string_view text, double unit) {
  const std::optional<PrintedNumber> peak = first_number(text);
  if (!peak) return;
  state_peak(channel, peak->value, unit);
  channel.peak_digit = unit * peak->digit;
}

void state_peak(RecordChannel& channel, double peak, double unit) { channel.stated_peak = unit * std::abs(peak); }

void check_samples(RecordChannel& channel) {
  constexpr double round_off = 1e-3, small_mean = 0.02;
  double peak = 0.0;
  for (const double sample : channel.samples) peak = std::max(peak, std::abs(sample));
  const double tolerance = std::max(round_off * channel.stated_peak, 0.501 * channel.peak_digit);
  if (channel.stated_peak > 0.0 && std::abs(peak - channel.stated_peak) > tolerance)
    channel.warnings.push_back("the header says a peak of " + to_text(channel.stated_peak) +
                               " m/s^2, the samples reach " + to_text(peak) + " m/s^2: damaged?");
  const double mean = std::accumulate(channel.samples.begin(), channel.samples.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(1, channel.samples.size()));
  if (std::abs(mean) > small_mean * peak)
    channel.warnings.push_back("the mean of the samples is " +
                               to_text(std::round(1000.0 * std::abs(mean) / peak) / 10.0) +
                               " % of their peak: an offset? high_passed() takes it away");
}

}  // namespace moat
