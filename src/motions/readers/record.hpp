// Records of earthquakes: two horizontal components in a right-handed frame, and the vertical one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"
#include "motions/plan_motion.hpp"
#include "motions/readers/record_channel.hpp"

namespace moat {

/// The horizontal axes of a record:
///
///      north ^     y            x: at `azimuth` from north, clockwise
///            |    /             y: 90 degrees counter-clockwise of x, at azimuth - 90 degrees
///            |   /   _- x       a_x = E sin azimuth + N cos azimuth
///            |  / _-'           a_y = -E cos azimuth + N sin azimuth
///            | /-'              z: up
///            +--------> east
struct RecordFrame {
  double azimuth = 90.0;           ///< of x, >= 0 and < 360 degrees
  bool is_assumed = false;         ///< The files do not say the azimuths; the second was taken as 90 degrees clockwise.
  bool is_mixed = false;           ///< The motions are combinations of both channels.
  std::vector<double> channels{};  ///< Azimuths of the channels from which the motions were made, degrees
};

/// A record at one station. All motions start at the same time, with the same step.
struct Record {
  std::string name;                        ///< From the names of its files.
  GroundMotion first;                      ///< Along x of the frame.
  std::optional<GroundMotion> second{};    ///< Along y; a record of one horizontal component has none.
  std::optional<GroundMotion> vertical{};  ///< Positive upwards.
  /// Axes of the record.
  RecordFrame frame{};

  /// The pair, with the vertical component, at an incidence of 0. Throws InputError for one horizontal component.
  [[nodiscard]] PlanMotion plan() const;
};

/// How files become records.
struct RecordOptions {
  /// Azimuth of x: every pair is turned to it. Else x is the channel whose azimuth is 90 degrees larger than that of
  /// the other, so that both are as in their files; of channels that are not square x is east.
  std::optional<Angle> x_azimuth{};
  /// A table that decides before the files (CSV, absolute or within the folder); else records.csv in the folder, if it
  /// is there.
  std::filesystem::path table{};
  /// For plain text; the table may say them too.
  TextColumns text{};
};

/// Reads the records in a folder, in the order of their first files.
///
/// Channels belong together that have one network, station, location and start (within 2 s, else the event); a
/// corrected and an uncorrected one also where their times overlap, and the lower level is left out. Among them the
/// vertical one and the horizontal azimuths are known by content, else by the names of files (read_channels); never by
/// the place in a file. Of a component that is there twice the longer one is taken. With e_i = (sin a_i, cos a_i)
/// channels measure s_i = e_i . (E, N), solved for E and N: exact also where they are not square, which is said from 2
/// degrees on and refused from 30 on. L and T, H1 and H2 without azimuths are assumed to be 90 degrees apart, the
/// second clockwise. A start that is later by whole steps is filled with zeros in front; of unequal steps the longer
/// must be a multiple of the shorter; shorter channels end in zeros.
///
/// Every file is noted as read or left out, with the reason (record_folder_notes()); files that are no records are left
/// out, damaged ones are refused. The table has a line of names, of which only `file` is needed, then rows:
///
///     file,channel,record,component,azimuth,unit,step,sign,columns
///     a.txt,1,Kobe,x,,gal,0.02,-1,"time,x"
///
/// component: x, y, z, first, second, vertical, out, or empty as recognised; azimuth in degrees; unit, step in s and
/// columns (TextColumns) of plain text; sign 1 or -1. x and y are taken as they are, without regard to azimuths.
///
/// Throws FileError for a folder without records, for more than two horizontal components of one station, for two
/// records of one name, as read_channels(), and for a table that is not of this form.
std::vector<Record> read_records(const std::filesystem::path& folder, const RecordOptions& options = {});

/// Reads the one record in these files, or in a folder. All files are used: one that is no record is refused. Throws as
/// read_records(), and as check_text() for one file.
Record read_record(const std::vector<std::filesystem::path>& files, const RecordOptions& options = {});

/// Writes the table of all channels that this program has read in this way, or of those in one folder, as files and
/// tables say them: given back, edited or not, it makes the same records of the same files. Facts that were assumed or
/// resampled stay empty, or as in the file. Behind the columns above are format, level, reason, peak in m/s^2 and
/// start.
void write_record_table(const std::filesystem::path& file, const std::filesystem::path& folder = {});

}  // namespace moat
