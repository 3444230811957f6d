// The layouts of record files. Each has a function that recognises it and one that reads its channels;
// motions/readers/read_channels.cpp lists them. Facts about the layouts: the files of the networks themselves, and the
// readers of the USGS's program gmprocess for them.
#pragma once

#include <vector>

#include "motions/readers/record_channel.hpp"

namespace moat {

struct TextFile;

/// K-NET and KiK-net (NIED, Japan): 17 lines of header, values from column 19; counts, 8 on a line:
///
///     Dir.              E-W                      KiK-net: 1 2 3 are NS, EW, UD in the borehole, 4 5 6 at the surface
///     Scale Factor      3920(gal)/6182761        a = 3920/6182761 gal (n - mean of all n)
///     Record Time       2018/01/24 19:51:43      UTC + 9 h, and 15 s behind the first sample
bool is_knet(const TextFile& file);
std::vector<RecordChannel> read_knet(const TextFile& file);  ///< Returns its channels.

/// AFAD (Turkey), older files: 18 lines KEY : value, the last one with the order of the columns; gal.
bool is_afad(const TextFile& file);
std::vector<RecordChannel> read_afad(const TextFile& file);  ///< Returns its channels.

/// DYNA (ESM, ITACA, TADAS; Luzi et al. (2016), Seismological Research Letters 87(4)): lines KEY: VALUE, 64 in
/// DYNA 1.2, with SAMPLING_INTERVAL_S, NDATA, UNITS: cm/s^2 and DATA_TYPE: ACCELERATION, then one value on each line.
bool is_dyna(const TextFile& file);
std::vector<RecordChannel> read_dyna(const TextFile& file);  ///< Returns its channels.

/// CWA, formerly CWB (Taiwan): lines #Key: value up to "#Data: 4F10.3", which name columns and signs; gal.
bool is_cwa(const TextFile& file);
std::vector<RecordChannel> read_cwa(const TextFile& file);  ///< Returns its channels.

/// GeoNet (New Zealand) V2A and V1A: for each channel 16 lines of text, 4 of 10 whole numbers, 6 of 10 numbers, then
/// acceleration, velocity and displacement in 10F8.1; mm/s^2.
bool is_geonet(const TextFile& file);
std::vector<RecordChannel> read_geonet(const TextFile& file);  ///< Returns its channels.

/// COSMOS 1.20 (COSMOS Strong-Motion Data Format, 2001), with any number of series:
///
///     Corrected acceleration    (Format v01.20 with 13 text lines)      and 12 more lines of text
///      100 Integer-header values follow on  10 lines, Format= (10I8)    2: quantity, 3: unit, 54: azimuth
///      100 Real-header values follow on  17 lines, Format= (6F13.6)     62: step in ms, 63: length in s, 64: peak
///        2 Comment line(s) follow, each starting with a "|":
///      4000 acceleration pts, approx  80 secs, units=cm/sec2(04),Format=(8F10.5)
///      End-of-data for Chan  1 acceleration                             or /& ---- End of data
///
/// Units by their number in the format's table: 02 g, 04 cm/s^2, 07 in/s^2, 10 gal, 11 mg. Series of other quantities
/// are left out with a warning on the others.
bool is_cosmos(const TextFile& file);
std::vector<RecordChannel> read_cosmos(const TextFile& file);  ///< Returns its channels.

/// RENADIC (Chile): uncorrected; 13 + 7 + 7 lines for each channel, then pairs of time and acceleration in g/10.
bool is_renadic(const TextFile& file);
std::vector<RecordChannel> read_renadic(const TextFile& file);  ///< Returns its channels.

/// BHRC (Iran): uncorrected; 13 + 7 + 7 lines for each channel, then 10E13.6 in g/10; step = duration / count.
bool is_bhrc(const TextFile& file);
std::vector<RecordChannel> read_bhrc(const TextFile& file);  ///< Returns its channels.

/// SMC (USGS): 11 lines of text, 6 of 8I10, 10 of 5E15.7, comments, then 8 columns of 10 characters; cm/s^2.
bool is_smc(const TextFile& file);
std::vector<RecordChannel> read_smc(const TextFile& file);  ///< Returns its channels.

/// CSMIP and CESMD (California) V2: for each channel 25 lines of text, 7 of 16I5, 13 of 8 columns of 10 characters,
/// then acceleration, velocity and displacement, each behind a line with count and format; old files state no format
/// and have 8 columns of 10.
bool is_csmip(const TextFile& file);
std::vector<RecordChannel> read_csmip(const TextFile& file);  ///< Returns its channels.

/// UNAM (Mexico), Archivo Estandar de Aceleracion: lines KEY : value, lists between slashes, columns in gal.
bool is_unam(const TextFile& file);
std::vector<RecordChannel> read_unam(const TextFile& file);  ///< Returns its channels.

/// PEER AT2: four lines of header, then accelerations in g, any number on a line.
///
///     Kobe Japan, 1/16/1995, KJMA, 90          event, station and component
///     ACCELERATION TIME SERIES IN UNITS OF G
///     NPTS=   5600, DT=   .0050 SEC            or: 4000    0.0050    NPTS, DT
///
/// Values that touch are separated where a sign follows an exponent ("-.123E-03-.456E-03"); any other contact is
/// refused, because it could be read in two ways. A file named .AT2 without such a header is one all the same, unless
/// it begins with numbers.
bool is_peer_at2(const TextFile& file);
std::vector<RecordChannel> read_peer_at2(const TextFile& file);  ///< Returns its channels.

/// Plain text: columns separated by blanks, tabs, one comma or one semicolon; the decimal sign is a point. Empty lines
/// and text behind #, %, ! or // are skipped, and one heading; both may say the step. A first time is 0 or one step.
bool is_plain_text(const TextFile& file);
std::vector<RecordChannel> read_plain_text(const TextFile& file,
                                           const TextColumns& columns);  ///< Returns its channels.

/// Throws NotARecord for files that are known, and no histories of acceleration, or raw counts: their message names
/// them and the way out.
void refuse_other_records(const TextFile& file);
/// Throws NotARecord for binary formats that are known; reads the beginning of the file.
void refuse_binary_records(const std::filesystem::path& path);

}  // namespace moat
