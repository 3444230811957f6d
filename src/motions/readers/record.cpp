#include "motions/readers/record.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.hpp"
#include "base/text/text_file.hpp"
#include "base/units.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/record_folder.hpp"
#include "motions/readers/record_lines.hpp"
#include "motions/readers/record_table.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

/// The channels of one record.
using Group = std::vector<SortedChannel*>;

constexpr double degree = units::pi / 180.0, right_angle = 90.0, circle = 360.0;

double turned(double azimuth) { return std::fmod(std::fmod(azimuth, circle) + circle, circle); }

std::string label_of(const SortedChannel& channel) {
  return channel.record.empty() ? channel.channel.station : channel.record;
}

std::string file_name_of(const SortedChannel& channel) {
  return fs::path{channel.channel.file.path}.filename().string();
}

bool belong_together(const SortedChannel& a, const SortedChannel& b) {
  if (!a.record.empty() || !b.record.empty()) return a.record == b.record;
  const RecordChannel &one = a.channel, &two = b.channel;
  constexpr double most_apart = 2.0;  // s
  const bool same_event =
      one.start && two.start ? std::abs(*one.start - *two.start) <= most_apart : one.event == two.event;
  return same_event && one.network == two.network && one.station == two.station && one.location == two.location;
}

bool is_same_component(const SortedChannel& a, const SortedChannel& b) {
  const RecordChannel &one = a.channel, &two = b.channel;
  if (one.vertical || two.vertical) return one.vertical == two.vertical;
  if (!a.component.empty() || !b.component.empty()) return a.component == b.component;
  constexpr double nearly = 0.5;  // degrees
  if (one.azimuth && two.azimuth) return std::abs(std::remainder(*one.azimuth - *two.azimuth, circle)) < nearly;
  return !one.azimuth && !two.azimuth && upper_case(one.component) == upper_case(two.component);
}

/// Leaves the better of two channels of one component.
void leave_out_repeated(const SortedFiles& all, Group& group) {
  const auto worth = [](const SortedChannel* each) {
    return std::pair{each->channel.level, each->channel.samples.size()};
  };
  for (std::size_t i = 0; i < group.size(); ++i)
    for (std::size_t k = i + 1; k < group.size();) {
      if (!is_same_component(*group[i], *group[k])) {
        ++k;
        continue;
      }
      if (!group[i]->component.empty() && !group[i]->channel.vertical)
        all.refuse(label_of(*group[i]) + " has two components " + group[i]->component + ", " + file_name_of(*group[i]) +
                   " and " + file_name_of(*group[k]) + ".");
      if (worth(group[k]) > worth(group[i])) std::swap(group[i], group[k]);
      const bool is_higher = group[i]->channel.level != group[k]->channel.level;
      all.note(*group[k], "left out: " + file_name_of(*group[i]) + " holds the same component, " +
                              (is_higher                            ? "further processed"
                               : worth(group[i]) == worth(group[k]) ? "and comes first"
                                                                    : "and is longer"));
      group.erase(group.begin() + static_cast<std::ptrdiff_t>(k));
    }
}

/// The name that the files have in common, without component.
std::string name_of(const Group& group) {
  if (!group[0]->record.empty()) return group[0]->record;
  std::string common = divided_name(group[0]->channel.file.path).station;
  for (const SortedChannel* each : group) {
    const std::string other = divided_name(each->channel.file.path).station;
    common.resize(static_cast<std::size_t>(std::ranges::mismatch(common, other).in1 - common.begin()));
  }
  common.resize(common.find_last_not_of("-_. ") + 1);
  if (common.empty()) common = label_of(*group[0]);
  const std::string& location = group[0]->channel.location;
  return location.empty() ? common : common + " " + location;
}

/// Completes azimuths: of L and T, or H1 and H2, the second is 90 degrees clockwise of the first.
void assume_azimuths(RecordChannel& one, RecordChannel& two) {
  static constexpr std::array leading{"L", "LONG", "H1", "R", "FN", "X"};
  const auto leads = [](const RecordChannel& channel) {
    const std::string word = upper_case(channel.component);
    return std::ranges::find(leading, word) != leading.end() || word.ends_with('1');
  };
  const bool one_leads = leads(one) || !leads(two);
  RecordChannel &lead = one_leads ? one : two, &other = one_leads ? two : one;
  if (!lead.azimuth) lead.azimuth = other.azimuth ? turned(*other.azimuth - right_angle) : 0.0;
  if (!other.azimuth) other.azimuth = turned(*lead.azimuth + right_angle);
}

/// The samples of channels with one step and one start, as many of each.
void align(const SortedFiles& all, const Group& group) {
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
    channel.start = start;
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
  const bool is_number = !channel.component.empty() && first_number(channel.component.substr(0, 1));
  return channel.source + " says " + quoted(channel.component) +
         (channel.azimuth && !is_number ? ", " + to_text(*channel.azimuth) + " deg" : "");
}

void take_as_they_are(const SortedFiles& all, SortedChannel& x, SortedChannel& y, Record& record) {
  record.first = motion_of(x.channel);
  record.second = motion_of(y.channel);
  all.note(x, "x of " + moat::quoted(record.name) + ": " + reason_of(x));
  all.note(y, "y of " + moat::quoted(record.name) + ": " + reason_of(y));
}

/// Two horizontal channels of known azimuths along x and y of the record's frame.
void resolve(const SortedFiles& all, SortedChannel& one, SortedChannel& two, const std::optional<Angle>& x_azimuth,
             Record& record) {
  const double a = *one.channel.azimuth, b = *two.channel.azimuth;
  const double apart = std::abs(std::remainder(a - b, circle)), off = std::abs(apart - right_angle);
  const std::string angles = to_text(a) + " and " + to_text(b) + " deg are " + to_text(apart) + " deg apart";
  constexpr double square = 0.1, doubtful = 2.0, nearly_parallel = 30.0;
  if (off > nearly_parallel)
    all.refuse(file_name_of(one) + " and " + file_name_of(two) + " of " + label_of(one) +
               " are no pair at right angles: " + angles + ".");
  const bool one_is_first = turned(a - b) < 180.0;
  SortedChannel &x = one_is_first ? one : two, &y = one_is_first ? two : one;
  record.frame.azimuth = turned(x_azimuth ? x_azimuth->si() / degree : off < square ? *x.channel.azimuth : right_angle);
  record.frame.is_mixed =
      off >= square || std::abs(std::remainder(record.frame.azimuth - *x.channel.azimuth, circle)) > 1e-9;
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

/// Of one horizontal channel a record only where `pairs_only` is false.
std::optional<Record> record_of(const SortedFiles& all, Group group, const RecordOptions& options, bool pairs_only) {
  leave_out_repeated(all, group);
  const auto middle =
      std::ranges::stable_partition(group, [](const SortedChannel* each) { return !each->channel.vertical; }).begin();
  const Group horizontal{group.begin(), middle};
  if (pairs_only && !horizontal.empty()) {
    std::for_each(middle, group.end(), [&](SortedChannel* each) { all.note(*each, "left out: " + reason_of(*each)); });
    group.resize(horizontal.size());
  }
  const Group vertical{group.begin() + static_cast<std::ptrdiff_t>(horizontal.size()), group.end()};
  if (horizontal.empty()) {
    all.note(*vertical[0], "left out: " + reason_of(*vertical[0]) + ", and " + label_of(*vertical[0]) +
                               " has no horizontal component");
    return std::nullopt;
  }
  if (horizontal.size() > 2) {
    std::string list;
    for (const SortedChannel* each : horizontal) list += (list.empty() ? "" : ", ") + each->channel.component;
    all.refuse(label_of(*horizontal[0]) + " has " + std::to_string(horizontal.size()) + " horizontal components (" +
               list + "), which are no pair at right angles: leave out all but two.");
  }
  if (horizontal.size() == 1 && pairs_only) {
    for (SortedChannel* each : group)
      all.note(*each,
               "left out: " + reason_of(*each) + ", and " + label_of(*each) + " has no second horizontal component");
    return std::nullopt;
  }
  align(all, group);
  SortedChannel& one = *horizontal[0];
  Record record{.name = name_of(group), .first = motion_of(one.channel)};
  if (horizontal.size() == 1) {
    record.frame.is_assumed = !one.channel.azimuth;
    record.frame.azimuth = one.channel.azimuth.value_or(right_angle);
    all.note(one, "x of " + moat::quoted(record.name) + ", a record of one horizontal component: " + reason_of(one));
  } else {
    SortedChannel& two = *horizontal[1];
    const bool by_table = !one.component.empty() || !two.component.empty();
    record.frame.is_assumed = !one.channel.azimuth || !two.channel.azimuth;
    if (by_table) {
      const bool one_is_first = one.component == "x" || two.component == "y";
      SortedChannel &x = one_is_first ? one : two, &y = one_is_first ? two : one;
      record.frame.azimuth = x.channel.azimuth.value_or(right_angle);
      take_as_they_are(all, x, y, record);
    } else {
      assume_azimuths(one.channel, two.channel);
      resolve(all, one, two, options.x_azimuth, record);
    }
    if (record.frame.is_assumed)
      all.note("azimuths of " + moat::quoted(record.name) + " are assumed: its files do not say them all.");
  }
  for (const SortedChannel* each : horizontal)
    if (each->channel.azimuth) record.frame.channels.push_back(*each->channel.azimuth);
  if (!vertical.empty()) {
    record.vertical = motion_of(vertical[0]->channel);
    all.note(*vertical[0], "z of " + moat::quoted(record.name) + ": " + reason_of(*vertical[0]));
  }
  return record;
}

void refuse_undecided(SortedFiles& all) {
  std::string undecided;
  for (const SortedChannel& each : all.channels())
    if (each.channel.component.empty()) undecided += (undecided.empty() ? "" : ", ") + file_name_of(each);
  if (!undecided.empty())
    all.refuse("neither header nor name says whether " + undecided + " is horizontal or vertical.");
}

std::vector<Record> records_of(SortedFiles& all, const RecordOptions& options, bool pairs_only = false) {
  refuse_undecided(all);
  std::vector<Group> groups;
  for (SortedChannel& channel : all.channels()) {
    // Words of --record-columns are those of the table.
    if (channel.channel.source == "--record-columns" && channel.component.empty())
      channel.component = channel.channel.component;
    const auto group =
        std::ranges::find_if(groups, [&](const Group& each) { return belong_together(*each[0], channel); });
    (group == groups.end() ? groups.emplace_back() : *group).push_back(&channel);
  }
  std::vector<Record> records;
  for (const Group& group : groups) {
    std::optional<Record> record = record_of(all, group, options, pairs_only);
    if (!record) continue;
    if (std::ranges::find(records, record->name, &Record::name) != records.end())
      all.refuse("two records have the name " + record->name + ".");
    records.push_back(std::move(*record));
  }
  return records;
}

}  // namespace

PlanMotion Record::plan() const {
  Check{"Record", name}.that(second.has_value(), "it has one horizontal component.",
                             "A model in plan needs two; a model on a line takes .first.");
  return {first, *second, {}, vertical};
}

std::vector<Record> read_records(const fs::path& folder, const RecordOptions& options) {
  SortedFiles all{folder, options};
  std::vector<Record> records = records_of(all, options);
  if (records.empty()) all.refuse("there is no horizontal component.");
  return records;
}

Record read_record(const std::vector<fs::path>& files, const RecordOptions& options) {
  const bool is_folder = files.size() == 1 && fs::is_directory(files[0]);
  SortedFiles all = is_folder ? SortedFiles{files[0], options} : SortedFiles{files, options};
  std::vector<Record> records = records_of(all, options);
  if (records.size() != 1) {
    std::string names;
    for (const Record& record : records) names += (names.empty() ? "" : ", ") + record.name;
    all.refuse("expected the files of one record, but found " + std::to_string(records.size()) +
               (names.empty() ? "." : ": " + names + "."));
  }
  return std::move(records[0]);
}

std::vector<GroundMotion> read_record_folder(const fs::path& folder) {
  SortedFiles all{folder, {}};
  refuse_undecided(all);
  std::vector<GroundMotion> motions;
  for (SortedChannel& each : all.channels()) {
    if (each.channel.vertical)
      all.note(each, "left out: " + reason_of(each));
    else
      motions.push_back(motion_of(each.channel));
  }
  if (motions.empty()) all.refuse("there is no horizontal component.");
  return motions;
}

std::vector<PlanMotion> read_record_pairs(const fs::path& folder) {
  std::vector<PlanMotion> pairs;
  SortedFiles all{folder, {}};
  for (const Record& record : records_of(all, {}, true)) pairs.push_back({record.first, *record.second, {}});
  if (pairs.empty()) all.refuse("no record has two components.");
  return pairs;
}

}  // namespace moat
