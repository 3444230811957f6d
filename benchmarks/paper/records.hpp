// The four near-fault records of Table 3, from the folder that MOAT_RECORDS names.
#pragma once

#include <moat.hpp>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace moat::paper {

struct PaperRecord {
  const char* earthquake;
  const char* station;  ///< as Table 3 calls it
  const char* file;     ///< in the PEER NGA-West2 database
  const char* label;    ///< in legends
};

/// In the order of Table 3. The identification is ours: the paper names stations, not files.
inline constexpr std::array<PaperRecord, 4> paper_records{{
    {"Kocaeli 1999", "Gebze", "RSN1161_KOCAELI_GBZ000.AT2", "GBZ000"},
    {"Kobe 1995", "Kobe University", "RSN1108_KOBE_KBU000.AT2", "KBU000"},
    {"Northridge 1994", "Administrative Building", "RSN982_NORTHR_JEN022.AT2", "JEN022"},
    {"Loma Prieta 1989", "Saratoga-W Valley Coll", "RSN803_LOMAP_WVC270.AT2", "WVC270"},
}};
inline constexpr std::size_t gebze = 0;

/// Empty if all records are there, else the missing ones and their source.
inline std::string missing_records() {
  const std::string where =
      " Download RSN 1161, 1108, 982 and 803 (components GBZ000, KBU000, JEN022, WVC270) from PEER NGA-West2, "
      "https://ngawest2.berkeley.edu, and set MOAT_RECORDS to their folder.";
  const char* folder = std::getenv("MOAT_RECORDS");
  if (folder == nullptr || *folder == '\0') return "MOAT_RECORDS is not set." + where;
  std::string missing;
  for (const PaperRecord& record : paper_records)
    if (!std::filesystem::exists(std::filesystem::path{folder} / record.file))
      missing.append(missing.empty() ? "" : ", ").append(record.file);
  if (missing.empty()) return "";
  return "The folder of MOAT_RECORDS lacks " + missing + "." + where;
}

/// A record as it is in its file. Throws FileError if it is not there.
inline GroundMotion read_unscaled(const PaperRecord& record) {
  const char* folder = std::getenv("MOAT_RECORDS");
  return read_motion(std::filesystem::path{folder == nullptr ? "" : folder} / record.file);
}

inline const Acceleration paper_pga = 0.4 * units::g;

/// All four, scaled to 0.4 g.
inline std::vector<GroundMotion> scaled_records() {
  std::vector<GroundMotion> motions;
  for (const PaperRecord& record : paper_records) motions.push_back(read_unscaled(record).scaled_to_pga(paper_pga));
  return motions;
}

/// GBZ000 made like the older processing that the paper used: a causal high-pass that brings PGV/PGA near the printed
/// 0.21 s. A reconstruction of ours, not a documented processing.
inline GroundMotion reconstructed_gebze() {
  return high_passed(read_unscaled(paper_records[gebze]), 0.068 * units::Hz, 5);
}

inline std::vector<std::string> record_labels() {
  std::vector<std::string> labels;
  for (const PaperRecord& record : paper_records) labels.emplace_back(record.label);
  return labels;
}

}  // namespace moat::paper
