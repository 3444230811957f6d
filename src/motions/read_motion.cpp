#include "motions/read_motion.hpp"

#include <cmath>
#include <string>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "motions/peer_at2.hpp"
#include "motions/text_file.hpp"
#include "motions/two_column_text.hpp"

namespace moat {
namespace {

bool is_peer_at2(const std::filesystem::path& path) {
  const std::string content = read_text_file(path);
  if (has_peer_at2_header(content)) return true;
  return upper_case(path.extension().string()) == ".AT2" && !begins_with_two_columns(content);
}

}  // namespace

GroundMotion read_motion(const std::filesystem::path& path, std::optional<Acceleration> unit) {
  const Check check{"read_motion", path.string()};
  if (is_peer_at2(path)) {
    check.that(!unit || std::abs(unit->si() - standard_gravity) < 1e-9 * standard_gravity,
               "a unit of " + to_text(unit ? unit->si() : 0.0) +
                   " m/s^2 was given, but a PEER AT2 file holds accelerations in g.",
               "Leave the unit out, and use scaled_by() if the values are to be multiplied.");
    return read_peer_at2(path);
  }
  check.that(unit.has_value(),
             "this is not a PEER AT2 file; as two columns of text it does not say the unit of its accelerations.",
             "Give the unit: read_motion(file, 1 * g), or 1 * m / s / s.");
  return read_two_columns(path, *unit);
}

}  // namespace moat
