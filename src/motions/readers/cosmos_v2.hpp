// Accelerograms in the COSMOS strong-motion data format.
#pragma once

#include <filesystem>

#include "motions/ground_motion.hpp"

namespace moat {

struct TextFile;

/// True if the first line announces the COSMOS format: "(Format v01.20 with 13 text lines)".
bool is_cosmos(const TextFile& file);

/// Reads one channel of acceleration in the COSMOS format, version 1.20 (COSMOS Strong-Motion Data Format, Consortium
/// of Organizations for Strong Motion Observation Systems, 2001). The parts of a file, in this order:
///
///     Corrected acceleration    (Format v01.20 with 13 text lines)      and 12 more lines of text
///      100 Integer-header values follow on  10 lines, Format= (10I8)    value 2: 1 for acceleration; value 3: unit
///      100 Real-header values follow on  17 lines, Format= (6F13.6)     value 62: interval of the samples in ms;
///                                                                       value 63: length in s
///        2 Comment line(s) follow, each starting with a "|":
///      4000 acceleration pts, approx  80 secs, units=cm/sec2(04),Format=(8F10.5)
///      End-of-data for Chan  1 acceleration
///
/// Values stand in the columns that the Fortran format (F, E, D, G or I) gives, so that neighbours may touch. Units, by
/// their number in the format's table: 02 g, 04 cm/s^2, 10 gal, 11 mg. The length must agree with count and interval
/// to 1 %, unless it is the value for "unknown", -999. The motion is named after the file, its notes are the lines of
/// text.
///
/// Throws FileError naming file, line and the mistake: a missing part, a wrong count, another quantity or unit (raw
/// counts, velocity), something that is not a number, or a second channel.
GroundMotion parse_cosmos(const TextFile& file);
/// Reads such a motion from a file on disk.
GroundMotion read_cosmos(const std::filesystem::path& path);

}  // namespace moat
