#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/check.hpp"
#include "base/text/text_file.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"

namespace moat {
namespace {

/// A layout that says its unit itself. The first that recognises a file reads it.
struct Layout {
  const char* name;
  bool (*recognises)(const TextFile& file);
  std::vector<RecordChannel> (*read)(const TextFile& file);
};

// GeoNet, SMC and RENADIC stand before CSMIP: all of them speak of corrected accelerograms.
constexpr std::array layouts{Layout{"K-NET", is_knet, read_knet},
                             Layout{"AFAD", is_afad, read_afad},
                             Layout{"ESM (DYNA)", is_dyna, read_dyna},
                             Layout{"CWA", is_cwa, read_cwa},
                             Layout{"GeoNet", is_geonet, read_geonet},
                             Layout{"COSMOS", is_cosmos, read_cosmos},
                             Layout{"RENADIC", is_renadic, read_renadic},
                             Layout{"BHRC", is_bhrc, read_bhrc},
                             Layout{"SMC", is_smc, read_smc},
                             Layout{"CSMIP V2", is_csmip, read_csmip},
                             Layout{"UNAM", is_unam, read_unam},
                             Layout{"PEER AT2", is_peer_at2, read_peer_at2}};

std::vector<RecordChannel> parsed(const TextFile& file, const TextColumns& text) {
  if (file.text.starts_with("file,channel,record,"))
    throw NotARecord{file.path.string() +
                     ": this is a table of records. Scripts take it by --records-table, beside --record."};
  const auto layout = std::ranges::find_if(layouts, [&](const Layout& each) { return each.recognises(file); });
  // A name alone makes a file one of PEER.
  if (layout == layouts.end() || layout->read == read_peer_at2) refuse_other_records(file);
  if (layout != layouts.end()) return layout->read(file);
  if (!is_plain_text(file))
    throw NotARecord{file.path.string() + ": unknown format. Known are " + motion_formats() +
                     ". Plain text needs lines of numbers behind comments with # and at most one heading."};
  return read_plain_text(file, text);
}

// A folder of records may hold other files.
TextFile text_of(const std::filesystem::path& path) try {
  return read_text_file(path);
} catch (const FileError& error) {
  throw NotARecord{error.what()};
}

}  // namespace

std::vector<RecordChannel> read_channels(const std::filesystem::path& path, const TextColumns& text) {
  refuse_binary_records(path);
  TextFile file = text_of(path);
  // Old files are filled with Ctrl-Z.
  file.text.erase(file.text.find_last_not_of(std::string_view{"\x1A\0", 2}) + 1);
  std::vector<RecordChannel> channels = parsed(file, text);
  const FileRead read = file_of(file);
  const DividedName divided = divided_name(path);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    RecordChannel& channel = channels[i];
    channel.file = read;
    channel.number = i + 1;
    channel.count = channels.size();
    channel.name = path.stem().string();
    if (channel.samples.size() < 2)
      refuse_file(path, "channel " + std::to_string(i + 1) + " has fewer than two values.");
    if (channel.count == 1 && channel.component.empty() && !divided.component.empty()) {
      set_component(channel, divided.component, "its name");
      channel.station = divided.station;
    }
    if (channel.count > 1 || (!divided.component.empty() && divided.station == channel.name))
      channel.name += " " + (channel.component.empty() ? std::to_string(i + 1) : channel.component);
    if (channel.station.empty()) channel.station = path.stem().string();
    if (channel.level == RecordLevel::uncorrected)
      channel.warnings.insert(channel.warnings.begin(), "this is the uncorrected record");
    check_samples(channel);
  }
  return channels;
}

void check_text(const std::vector<RecordChannel>& channels, const TextColumns& text) {
  const RecordChannel& channel = channels.at(0);
  const std::optional<double> own = acceleration_unit(channel.unit);
  if (channel.format == "text" || !own) return;
  const Check check{"read_motion", channel.file.path};
  const std::string here = ", but this file (" + channel.format + ") ";
  check.that(!text.unit || std::abs(text.unit->si() - *own) < 1e-9 * *own,
             "a unit of " + to_text(text.unit ? text.unit->si() : 0.0) + " m/s^2 was given" + here +
                 "holds accelerations in " + channel.unit + ".",
             "Leave the unit out, and use scaled_by() if the values are to be multiplied.");
  check.that(!text.step || std::abs(text.step->si() - channel.step) < 1e-5 * channel.step,
             "a step of " + to_text(text.step ? text.step->si() : 0.0) + " s was given" + here + "has one of " +
                 to_text(channel.step) + " s.",
             "Leave the step out.");
  check.that(text.columns.empty(), "columns were named, \"" + text.columns + "\"" + here + "names its own.",
             "Leave the columns out.");
}

GroundMotion motion_of(const RecordChannel& channel) {
  std::vector<std::string> notes = channel.notes;
  notes.insert(notes.end(), channel.warnings.begin(), channel.warnings.end());
  if (channel.vertical)
    notes.push_back(channel.name + vertical_record + channel.source + " says " + quoted(channel.component) + ".");
  return {channel.name, channel.step, channel.samples, std::move(notes), channel.file};
}

std::string motion_formats() {
  std::string list;
  for (const Layout& layout : layouts) list.append(layout.name).append(", ");
  return list + "or columns of text";
}

}  // namespace moat
