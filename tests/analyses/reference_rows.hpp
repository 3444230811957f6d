// The peaks of an independent program (benchmarks/paper/reference_peaks.csv) and the records they belong to.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "moat.hpp"
#include "peak_in.hpp"

namespace moat::testing {

using Row = std::map<std::string, std::string>;

inline std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream{line};
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

inline Row reference_row(const std::string& record, const std::string& row_name) {
  const std::filesystem::path path = std::filesystem::path{MOAT_SOURCE_DIR} / "benchmarks/paper/reference_peaks.csv";
  std::ifstream file{path};
  std::vector<std::string> names;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    const auto cells = split(line);
    if (names.empty()) {
      names = cells;
      continue;
    }
    Row row;
    for (std::size_t i = 0; i < std::min(cells.size(), names.size()); ++i) row[names[i]] = cells[i];
    if (row["record"] == record && row["case"] == row_name) return row;
  }
  ADD_FAILURE() << "no row " << row_name << " of " << record << " in " << path;
  return {};
}

inline double largest(const CaseResult& result, const std::string& quantity) {
  double value = 0.0;
  for (const Peak& found : result.peaks)
    if (found.quantity == quantity) value = std::max(value, found.magnitude());
  return value;
}

inline std::filesystem::path record_file(const std::string& record) {
  const char* folder = std::getenv("MOAT_RECORDS");
  return folder == nullptr ? std::filesystem::path{} : std::filesystem::path{folder} / (record + ".AT2");
}

/// Why a record cannot be used; empty if it can.
inline std::string why_missing(const std::string& record) {
  const std::filesystem::path file = record_file(record);
  if (file.empty()) return "set MOAT_RECORDS to a folder with PEER AT2 files to run this test";
  if (!std::filesystem::exists(file)) return file.string() + " is not there; MOAT_RECORDS names its folder";
  return {};
}

inline GroundMotion reference_motion(const std::string& record) {
  return read_motion(record_file(record)).scaled_to_pga(0.4 * units::g);
}

/// Tests on the records that INSTANTIATE_TEST_SUITE_P names; skipped where one is missing.
class OnReferenceRecords : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (const std::string missing = why_missing(record()); !missing.empty()) GTEST_SKIP() << missing;
    motion_ = std::make_unique<GroundMotion>(reference_motion(record()));
  }
  static std::string record() { return GetParam(); }

  std::unique_ptr<GroundMotion> motion_;
};

}  // namespace moat::testing
