#include "motions/readers/record.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/text/text_file.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/record_axes.hpp"
#include "motions/readers/record_folder.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

constexpr double east = 90.0, circle = 360.0;

double duration_of(const RecordChannel& channel) { return static_cast<double>(channel.samples.size()) * channel.step; }

bool is_same_event(const RecordChannel& one, const RecordChannel& two) {
  constexpr double most_apart = 2.0;  // s
  if (!one.start || !two.start) return one.event == two.event;
  // Processing cuts the record at both ends, or puts zeros there.
  if (one.level != two.level)
    return *one.start < *two.start + duration_of(two) && *two.start < *one.start + duration_of(one);
  return std::abs(*one.start - *two.start) <= most_apart;
}

bool belong_together(const SortedChannel& a, const SortedChannel& b) {
  if (!a.record.empty() || !b.record.empty()) return a.record == b.record;
  const RecordChannel &one = a.channel, &two = b.channel;
  return one.network == two.network && one.station == two.station && one.location == two.location &&
         is_same_event(one, two);
}

bool is_same_component(const SortedChannel& a, const SortedChannel& b) {
  const RecordChannel &one = a.channel, &two = b.channel;
  if (one.vertical || two.vertical) return one.vertical == two.vertical;
  if (!a.component.empty() || !b.component.empty()) return a.component == b.component;
  constexpr double nearly = 0.5;  // degrees
  if (one.azimuth && two.azimuth) return std::abs(std::remainder(*one.azimuth - *two.azimuth, circle)) < nearly;
  return !one.azimuth && !two.azimuth && upper_case(one.component) == upper_case(two.component);
}

/// Leaves the channels of the highest level: only the table may mix corrected and uncorrected ones.
void leave_out_lower_levels(const SortedFiles& all, RecordGroup& group) {
  const SortedChannel& best =
      **std::ranges::max_element(group, {}, [](const SortedChannel* each) { return each->channel.level; });
  std::erase_if(group, [&](SortedChannel* each) {
    const bool is_lower = each->component.empty() && each->channel.level < best.channel.level;
    if (is_lower) all.note(*each, "left out: " + file_name_of(best) + " holds this record, further processed");
    return is_lower;
  });
}

/// Leaves one of two channels of a component: that of the table, else the longer one.
void leave_out_repeated(const SortedFiles& all, RecordGroup& group) {
  const auto worth = [](const SortedChannel* each) {
    return std::pair{!each->component.empty(), each->channel.samples.size()};
  };
  for (std::size_t i = 0; i < group.size(); ++i)
    for (std::size_t k = i + 1; k < group.size();) {
      if (!is_same_component(*group[i], *group[k])) {
        ++k;
        continue;
      }
      if (!group[i]->component.empty() && !group[k]->component.empty())
        all.refuse(label_of(*group[i]) + " has two components " + group[i]->component + ", " + file_name_of(*group[i]) +
                   " and " + file_name_of(*group[k]) + ".");
      const RecordChannel &one = group[i]->channel, &two = group[k]->channel;
      if (one.event.empty() && !(one.start && two.start) && one.samples != two.samples)
        all.refuse(file_name_of(*group[i]) + " and " + file_name_of(*group[k]) + " hold the same component of " +
                   label_of(*group[i]) + ", and do not say of which earthquake.");
      if (worth(group[k]) > worth(group[i])) std::swap(group[i], group[k]);
      all.note(*group[k], "left out: " + file_name_of(*group[i]) + " holds the same component, " +
                              (!group[i]->component.empty()         ? "by the table"
                               : worth(group[i]) == worth(group[k]) ? "and comes first"
                                                                    : "and is longer"));
      group.erase(group.begin() + static_cast<std::ptrdiff_t>(k));
    }
}

/// The name that the files have in common, without component.
std::string name_of(const RecordGroup& group) {
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

/// Makes a record of one horizontal channel only where `pairs_only` is false.
std::optional<Record> record_of(const SortedFiles& all, RecordGroup group, const RecordOptions& options,
                                bool pairs_only) {
  leave_out_lower_levels(all, group);
  leave_out_repeated(all, group);
  const auto middle = std::stable_partition(group.begin(), group.end(),
                                            [](const SortedChannel* each) { return !each->channel.vertical; });
  const RecordGroup horizontal{group.begin(), middle};
  if (pairs_only && !horizontal.empty()) {
    std::for_each(middle, group.end(), [&](SortedChannel* each) { all.note(*each, "left out: " + reason_of(*each)); });
    group.resize(horizontal.size());
  }
  const RecordGroup vertical{group.begin() + static_cast<std::ptrdiff_t>(horizontal.size()), group.end()};
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
    record.frame.azimuth = one.channel.azimuth.value_or(east);
    all.note(one, "x of " + moat::quoted(record.name) + ", a record of one horizontal component: " + reason_of(one));
  } else {
    SortedChannel& two = *horizontal[1];
    const bool by_table = !one.component.empty() || !two.component.empty();
    record.frame.is_assumed = !one.channel.azimuth || !two.channel.azimuth;
    if (by_table) {
      const bool one_is_first = one.component == "x" || two.component == "y";
      SortedChannel &x = one_is_first ? one : two, &y = one_is_first ? two : one;
      record.frame.azimuth = x.channel.azimuth.value_or(east);
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

std::vector<RecordGroup> groups_of(SortedFiles& all) {
  refuse_undecided(all);
  std::vector<RecordGroup> groups;
  for (SortedChannel& channel : all.channels()) {
    const auto group =
        std::ranges::find_if(groups, [&](const RecordGroup& each) { return belong_together(*each[0], channel); });
    (group == groups.end() ? groups.emplace_back() : *group).push_back(&channel);
  }
  return groups;
}

std::vector<Record> records_of(SortedFiles& all, const RecordOptions& options, bool pairs_only = false) {
  std::vector<Record> records;
  for (const RecordGroup& group : groups_of(all)) {
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
  for (RecordGroup& group : groups_of(all)) leave_out_lower_levels(all, group);
  std::vector<GroundMotion> motions;
  for (SortedChannel& each : all.channels()) {
    if (!each.fate.empty()) continue;
    all.note(each, (each.channel.vertical ? "left out: " : "used: ") + reason_of(each));
    if (!each.channel.vertical) motions.push_back(motion_of(each.channel));
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
