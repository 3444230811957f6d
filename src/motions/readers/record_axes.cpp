#include "motions/readers/record_axes.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "base/check.hpp"
#include "base/text/text_file.hpp"
#include "base/units.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr double degree = units::pi / 180.0, right_angle = 90.0, circle_of_azimuths = 360.0;

double turned(double azimuth) {
  return std::fmod(std::fmod(azimuth, circle_of_azimuths) + circle_of_azimuths, circle_of_azimuths);
}

}  // namespace

std::string label_of(const SortedChannel& channel) {
  return channel.record.empty() ? channel.channel.station : channel.record;
}

std::string file_name_of(const SortedChannel& channel) {
  return std::filesystem::path{channel.channel.file.path}.filename().string();
}

void assume_azimuths(RecordChannel& one, RecordChannel& two) {
  static constexpr std::array first{"L", "LONG", "H1", "R", "FN", "X"};
  static constexpr std::array second{"T", "TRAN", "H2", "FP", "Y"};
  // HN1 and HN2 are codes, 91 and 352 azimuths.
  const auto place_of = [](const RecordChannel& channel) {
    const std::string word = upper_case(channel.component);
    const bool is_code = !word.empty() && std::isalpha(static_cast<unsigned char>(word[0])) != 0;
    if (std::ranges::find(first, word) != first.end() || (is_code && word.ends_with('1'))) return 1;
    return std::ranges::find(second, word) != second.end() || (is_code && word.ends_with('2')) ? 3 : 2;
  };
  const bool one_leads = place_of(one) <= place_of(two);
  RecordChannel &lead = one_leads ? one : two, &other = one_leads ? two : one;
  if (!lead.azimuth) lead.azimuth = other.azimuth ? turned(*other.azimuth - right_angle) : 0.0;
  if (!other.azimuth) other.azimuth = turned(*lead.azimuth + right_angle);
}

void align(const SortedFiles& all, const RecordGroup& group) {
  double step = group[0]->channel.step;
  std::optional<double> start;
  for (const SortedChannel* each : group) {
    step = std::min(step, each->channel.step);
    if (each->channel.start) start = std::min(start.value_or(*each->channel.start), *each->channel.start);
  }
  std::size_t longest = 0;
  for (SortedChannel* each : group) {
    RecordChannel& channel = each->channel;
    constexpr double round_off = 1e-6, of_a_step = 0.01, most_finer = 1000.0, latest = 1000.0;  // s
    const double ratio = channel.step / step, finer = std::round(ratio);
    if (!(ratio <= most_finer) || std::abs(ratio - finer) > round_off * finer)
      all.refuse("the step of " + channel.name + " is " + to_text(channel.step) + " s, another one of the record " +
                 to_text(step) + " s: no whole ratio. Resample one of them.");
    const double later = channel.start ? *channel.start - *start : 0.0, delay = later / step,
                 steps = delay > 0.5 ? std::round(delay) : 0.0;
    if (later > latest || std::abs(delay - steps) > (steps > 0.0 ? of_a_step : 0.5))
      all.refuse(channel.name + " starts " + to_text(std::round(1e5 * later) / 1e5) +
                 " s later than another component, which is more than 1000 s, or no whole number of steps of " +
                 to_text(step) + " s. Cut or resample one of them.");
    if (steps > 0.0)
      all.note(channel.name + " starts " + to_text(steps * step) + " s later: zeros stand in front of it.");
    std::vector<double> samples(static_cast<std::size_t>(steps), 0.0);
    for (std::size_t i = 0; i + 1 < channel.samples.size(); ++i)
      for (double k = 0.0; k < finer; ++k)
        samples.push_back(channel.samples[i] + k / finer * (channel.samples[i + 1] - channel.samples[i]));
    samples.push_back(channel.samples.back());
    longest = std::max(longest, samples.size());
    channel.samples = std::move(samples);
    channel.step = step;
  }
  for (SortedChannel* each : group) {
    std::vector<double>& samples = each->channel.samples;
    if (const double missing = static_cast<double>(longest - samples.size()) * step; missing > 1.0)
      all.note(each->channel.name + " is " + to_text(missing) +
               " s shorter than another component: zeros stand behind it.");
    samples.resize(longest, 0.0);
  }
}

std::string reason_of(const SortedChannel& sorted) {
  const RecordChannel& channel = sorted.channel;
  const bool says_number = !channel.component.empty() && first_number(channel.component.substr(0, 1));
  return channel.source + " says " + quoted(channel.component) +
         (channel.azimuth && !says_number ? ", " + to_text(*channel.azimuth) + " deg" : "") +
         (channel.azimuth && !sorted.azimuth ? " assumed" : "");
}

void take_as_they_are(const SortedFiles& all, SortedChannel& x, SortedChannel& y, Record& record) {
  record.first = motion_of(x.channel);
  record.second = motion_of(y.channel);
  all.note(x, "x of " + moat::quoted(record.name) + ": " + reason_of(x));
  all.note(y, "y of " + moat::quoted(record.name) + ": " + reason_of(y));
}

void resolve(const SortedFiles& all, SortedChannel& one, SortedChannel& two, const std::optional<Angle>& x_azimuth,
             Record& record) {
  const double a = *one.channel.azimuth, b = *two.channel.azimuth;
  const double apart = std::abs(std::remainder(a - b, circle_of_azimuths)), off = std::abs(apart - right_angle);
  const std::string angles = to_text(a) + " and " + to_text(b) + " deg are " + to_text(apart) + " deg apart";
  constexpr double square = 0.1, doubtful = 2.0, nearly_parallel = 30.0;
  if (off > nearly_parallel)
    all.refuse(file_name_of(one) + " and " + file_name_of(two) + " of " + label_of(one) +
               " are no pair at right angles: " + angles + ".");
  const bool one_is_first = turned(a - b) < 180.0;
  SortedChannel &x = one_is_first ? one : two, &y = one_is_first ? two : one;
  record.frame.azimuth = turned(x_azimuth ? x_azimuth->si() / degree : off < square ? *x.channel.azimuth : right_angle);
  record.frame.is_mixed =
      off >= square || std::abs(std::remainder(record.frame.azimuth - *x.channel.azimuth, circle_of_azimuths)) > 1e-9;
  if (!record.frame.is_mixed) {
    take_as_they_are(all, x, y, record);
    return;
  }
  // s_i = E sin a_i + N cos a_i
  const double determinant = std::sin((a - b) * degree), sin_x = std::sin(record.frame.azimuth * degree),
               cos_x = std::cos(record.frame.azimuth * degree);
  std::vector<double> along, across;
  for (std::size_t i = 0; i < one.channel.samples.size(); ++i) {
    const double s = one.channel.samples[i], t = two.channel.samples[i];
    const double east = (s * std::cos(b * degree) - t * std::cos(a * degree)) / determinant;
    const double north = (t * std::sin(a * degree) - s * std::sin(b * degree)) / determinant;
    along.push_back(east * sin_x + north * cos_x);
    across.push_back(-east * cos_x + north * sin_x);
  }
  const std::string how = "resolved from " + one.channel.name + " and " + two.channel.name + ", azimuths " +
                          to_text(a) + " and " + to_text(b) + " deg, to azimuth ";
  const auto notes = [&](const RecordChannel& channel, double azimuth) {
    std::vector<std::string> lines = channel.notes;
    lines.push_back(how + to_text(turned(azimuth)) + " deg");
    return lines;
  };
  const double step = one.channel.step;
  record.first = GroundMotion{record.name + " x", step, std::move(along), notes(one.channel, record.frame.azimuth),
                              one.channel.file};
  record.second = GroundMotion{record.name + " y", step, std::move(across),
                               notes(two.channel, record.frame.azimuth - right_angle), two.channel.file};
  if (off > doubtful) all.note(angles + ": resolved exactly.");
  for (SortedChannel* each : {&one, &two})
    all.note(*each, "resolved into x and y of " + moat::quoted(record.name) + ", " + to_text(record.frame.azimuth) +
                        " deg: " + reason_of(*each));
}
}  // namespace moat
