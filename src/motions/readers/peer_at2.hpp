// Accelerograms in the AT2 format of the PEER strong motion databases.
#pragma once

#include <filesystem>
#include <string_view>

#include "motions/ground_motion.hpp"

namespace moat {

/// Reads a PEER AT2 file: four header lines, then accelerations in g = 9.80665 m/s^2, any number per line.
///
/// The third line must say "UNITS OF G". The fourth gives the number of values and the time step in s, in either of
/// the layouts in use:
///
///     NPTS=   5600, DT=   .0050 SEC,   4 POLE @    30.00000 HZ     (not read behind SEC)
///     4000    0.0050    NPTS, DT
///
/// Exponents are marked by E or D. Values that touch are separated where a sign follows an exponent
/// ("-.123E-03-.456E-03"); any other contact is refused, because it could be read in two ways. The motion is named
/// after the file, its notes are the header lines.
///
/// Throws FileError naming file, line and the mistake: no such file, unknown units or layout, something that is
/// not a number, or a number of values that differs from the header's.
GroundMotion read_peer_at2(const std::filesystem::path& path);

struct TextFile;
/// Reads such a motion from a file in memory.
GroundMotion parse_peer_at2(const TextFile& file);

/// True if the text begins with a PEER AT2 header, in any unit.
bool has_peer_at2_header(std::string_view text);

}  // namespace moat
