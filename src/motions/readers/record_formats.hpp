// The formats of accelerograms. Each has a function that recognises it, one that reads a file on disk, and one that
// parses its text; motions/readers/read_motion.cpp lists them.
#pragma once

#include <filesystem>

#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

struct TextFile;

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
/// Reads such a motion from a file in memory.
GroundMotion parse_peer_at2(const TextFile& file);
/// True if the text begins with a PEER AT2 header, in any unit.
bool has_peer_at2_header(const TextFile& file);

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
GroundMotion read_cosmos(const std::filesystem::path& path);
/// Reads such a motion from a file in memory.
GroundMotion parse_cosmos(const TextFile& file);
/// True if the first line announces the COSMOS format: "(Format v01.20 with 13 text lines)".
bool is_cosmos(const TextFile& file);

/// Reads a text file of the Engineering Strong Motion database (ESM) or ITACA, header format DYNA (Luzi et al. (2016),
/// Seismological Research Letters 87(4); the keys are explained on the pages of the database).
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
GroundMotion read_esm(const std::filesystem::path& path);
/// Reads such a motion from a file in memory.
GroundMotion parse_esm(const TextFile& file);
/// True if the first line is that of the database: "EVENT_NAME: ...".
bool is_esm(const TextFile& file);

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
/// Reads such a motion from a file in memory.
GroundMotion parse_two_columns(const TextFile& file, Acceleration unit);
/// True if the first line of the text that is neither empty nor a comment holds two numbers.
bool begins_with_two_columns(const TextFile& file);

}  // namespace moat
