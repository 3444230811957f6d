#include "motions/readers/read_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <string>

#include "base/check.hpp"
#include "base/text/text_file.hpp"
#include "base/units.hpp"
#include "motions/readers/record_folder.hpp"
#include "motions/readers/record_formats.hpp"

namespace moat {
namespace {

/// A way to write a record that says its unit itself. The first that recognises a file reads it.
struct Format {
  const char* name;
  bool (*recognises)(const TextFile& file);
  GroundMotion (*read)(const TextFile& file);
  /// m/s^2 and as text; 0 where every file has its own.
  double unit;
  const char* unit_name;
};

bool is_peer_at2(const TextFile& file) {
  if (has_peer_at2_header(file)) return true;
  return upper_case(file.path.extension().string()) == ".AT2" && !begins_with_two_columns(file);
}

constexpr std::array formats{Format{"PEER AT2", is_peer_at2, parse_peer_at2, standard_gravity, "g"},
                             Format{"COSMOS", is_cosmos, parse_cosmos, 0.0, "the unit that it states"},
                             Format{"ESM", is_esm, parse_esm, 0.01, "cm/s^2"}};
constexpr const char* two_columns = "two columns of time in s and acceleration";

// A unit beside that of the file is a mistake, unless it is the same.
void check_unit(const Format& format, const TextFile& file, const std::optional<Acceleration>& unit) {
  if (!unit) return;
  Check{"read_motion", file.path.native()}.that(
      std::abs(unit->si() - format.unit) < 1e-9 * format.unit,
      "a unit of " + to_text(unit->si()) + " m/s^2 was given, but " + format.name + " files hold accelerations in " +
          format.unit_name + ".",
      "Leave the unit out, and use scaled_by() if the values are to be multiplied.");
}

std::string names_of_formats(const char* last_separator) {
  std::string list;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const char* separator = i == 0 ? "" : i + 1 == formats.size() ? last_separator : ", ";
    list.append(separator).append(formats[i].name);
  }
  return list;
}

GroundMotion parsed(const TextFile& file, std::optional<Acceleration> unit) {
  const auto format = std::ranges::find_if(formats, [&](const Format& each) { return each.recognises(file); });
  if (format != formats.end()) {
    check_unit(*format, file, unit);
    return format->read(file);
  }
  if (!unit)
    throw MissingUnit{"read_motion \"" + file.path.string() + "\": this is not a " + names_of_formats(" or ") +
                          " file; as two columns of text it does not say the unit of its accelerations.",
                      "Give the unit: read_motion(file, 1 * g), or 1 * m / s / s."};
  return parse_two_columns(file, *unit);
}

}  // namespace

GroundMotion read_motion(const std::filesystem::path& path, std::optional<Acceleration> unit) try {
  const GroundMotion motion = parsed(read_text_file(path), unit);
  const std::string reason = says_vertical(motion);
  return reason.empty() ? motion
                        : motion.with_samples({motion.samples().begin(), motion.samples().end()},
                                              motion.name() + vertical_record + reason + ".");
} catch (const std::bad_alloc&) {
  refuse_file(path, "the memory is too small for this record. Cut the record, or end other programs.");
}

std::string motion_formats() { return names_of_formats(", ") + ", or " + two_columns; }

}  // namespace moat
