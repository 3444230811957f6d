// Accelerograms as two columns of text: time and acceleration.
#pragma once

#include <filesystem>
#include <string_view>

#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// Reads a text file of two columns, time in s and acceleration in `unit` (1 * g, 1 * m / s / s; must be > 0).
///
/// Columns are separated by blanks, tabs, one comma or one semicolon; the decimal sign is a point. Empty lines and all
/// text behind '#' or '%' are skipped; one line of words before the first data is taken as the heading of the columns.
/// Times must be evenly spaced: every interval within 1e-4 of the first one, relative to it. The first time is 0 or one
/// interval; either way the first sample is the start of the motion.
///
///     const GroundMotion motion = read_two_columns("record.csv", 1 * g);
///
/// Throws InputError for a unit that is not positive, FileError naming file and line for everything else.
GroundMotion read_two_columns(const std::filesystem::path& path, Acceleration unit);

struct TextFile;
/// Reads such a motion from a file in memory.
GroundMotion parse_two_columns(const TextFile& file, Acceleration unit);

/// True if the first line of the text that is neither empty nor a comment holds two numbers.
bool begins_with_two_columns(std::string_view text);

}  // namespace moat
