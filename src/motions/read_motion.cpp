#include "motions/read_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/check.hpp"
#include "base/units.hpp"
#include "motions/peer_at2.hpp"
#include "motions/text_file.hpp"
#include "motions/two_column_text.hpp"

namespace moat {
namespace {

/// One way to write a record. The first format that recognises a file reads it.
struct Format {
  const char* description;
  bool (*recognises)(const TextFile& file);
  GroundMotion (*read)(const TextFile& file, std::optional<Acceleration> unit);
};

bool is_peer_at2(const TextFile& file) {
  if (has_peer_at2_header(file.text)) return true;
  return upper_case(file.path.extension().string()) == ".AT2" && !begins_with_two_columns(file.text);
}

GroundMotion read_in_g(const TextFile& file, std::optional<Acceleration> unit) {
  Check{"read_motion", file.path.native()}.that(
      !unit || std::abs(unit->si() - standard_gravity) < 1e-9 * standard_gravity,
      "a unit of " + to_text(unit ? unit->si() : 0.0) +
          " m/s^2 was given, but a PEER AT2 file holds accelerations in g.",
      "Leave the unit out, and use scaled_by() if the values are to be multiplied.");
  return parse_peer_at2(file);
}

bool is_anything(const TextFile&) { return true; }

GroundMotion read_columns(const TextFile& file, std::optional<Acceleration> unit) {
  if (!unit)
    throw MissingUnit{"read_motion \"" + file.path.string() +
                      "\": this is not a PEER AT2 file; as two columns of text it does not say the unit of its "
                      "accelerations. Give the unit: read_motion(file, 1 * g), or 1 * m / s / s."};
  return parse_two_columns(file, *unit);
}

constexpr std::array formats{Format{"PEER AT2", is_peer_at2, read_in_g},
                             Format{"two columns of time in s and acceleration", is_anything, read_columns}};

}  // namespace

GroundMotion read_motion(const std::filesystem::path& path, std::optional<Acceleration> unit) {
  const TextFile file = read_text_file(path);
  return std::ranges::find_if(formats, [&](const Format& each) { return each.recognises(file); })->read(file, unit);
}

std::string motion_formats() {
  std::string list;
  for (const Format& format : formats) list.append(list.empty() ? "" : ", or ").append(format.description);
  return list;
}

}  // namespace moat
