// Accelerograms in the text format of the Engineering Strong Motion database (ESM) and of ITACA.
#pragma once

#include <filesystem>

#include "motions/ground_motion.hpp"

namespace moat {

struct TextFile;

/// True if the first line is that of the database: "EVENT_NAME: ...".
bool is_esm(const TextFile& file);

/// Reads a text file of ESM or ITACA, header format DYNA (Luzi et al. (2016), Seismological Research Letters 87(4); the
/// keys are explained on the pages of the database).
///
///     EVENT_NAME: ...               lines KEY: VALUE; 64 in header format DYNA 1.2
///     SAMPLING_INTERVAL_S: 0.005    needed, > 0 s
///     NDATA: 18904                  needed; the number of values
///     UNITS: cm/s^2                 needed; no other unit is read
///     DATA_TYPE: ACCELERATION       needed; unprocessed acceleration too, but no velocity and no spectrum
///     HEADER_FORMAT: DYNA 1.2
///     -0.001326                     then one value per line
///
/// The motion is named after the file, its notes are the header lines that have a value.
///
/// Throws FileError naming file, line and the mistake: a key that is missing or has another value, a wrong number of
/// header lines or of values, something that is not a number.
GroundMotion parse_esm(const TextFile& file);
/// Reads such a motion from a file on disk.
GroundMotion read_esm(const std::filesystem::path& path);

}  // namespace moat
