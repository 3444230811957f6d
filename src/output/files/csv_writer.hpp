// Tables as comma-separated text.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

/// Writes one header row (`time [s],displacement [m] base,...`) and one row per time.
///
/// A column with labels is called by its quantity alone and holds them instead of its numbers. Every number has the
/// fewest digits that read back to the same double; a missing value is `nan`. A name that contains a comma or a quote
/// is quoted as in RFC 4180. Throws InputError where columns differ in length, FileError where the file cannot be
/// written.
void write_csv(const Table& table, const std::filesystem::path& path);
/// Returns the header row of the file.
std::string csv_heading(const Table& table);

/// Writes the rows from this one on.
void write_csv_rows(const Table& table, std::size_t first, std::ostream& file);

/// One row per impact: `where,start [s],duration [s],approach_speed [m/s],largest_indentation [m],largest_force [N],
/// rebound_ratio [1],restitution [1],energy_lost [J]`. Without impacts only the header is written. Throws FileError.
void write_csv(const std::vector<Impact>& impacts, const std::filesystem::path& path);

/// peaks.csv: `building,place,quantity,unit,value,error,time [s],side`, one row per peak in SI units. The building is
/// that of the place; of one between two buildings "north and south"; empty where it is of none. An error that is not
/// known is empty. Throws FileError.
void write_peaks_csv(const CaseResult& result, const std::filesystem::path& path);

/// participating_masses.csv: `building,mode,period [s],x [%],y [%],rotation [%],sum x [%],sum y [%],sum rotation [%]`,
/// one row per mode of a building held at its base; nothing is written where no building has modes. Throws FileError.
void write_participating_masses_csv(const CaseResult& result, const std::filesystem::path& path);

/// bearing_checks.csv: `check,bearing,type,unit,demand,capacity,ratio,time [s],source`, one row per check of a bearing
/// in SI units; capacity and ratio are `nan` where it is not judged. Nothing is written without checks. Throws
/// FileError.
void write_bearing_checks_csv(const CaseResult& result, const std::filesystem::path& path);

/// floor_spectra.csv: `floor,place,direction,damping [1],period [s],pseudo_acceleration [m/s^2],absolute_acceleration
/// [m/s^2]`, one row per period; the place is "centre" or a corner, the direction "x" or "y". Absolute accelerations
/// are empty unless they were wanted. Nothing is written without spectra. Throws FileError.
void write_floor_spectra_csv(const CaseResult& result, const std::filesystem::path& path);

}  // namespace moat
