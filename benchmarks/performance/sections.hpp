// The questions of the benchmark, one function each.
#pragma once

#include <cstddef>
#include <filesystem>

#include "measuring/record.hpp"

namespace moat::performance {

struct Options {
  /// Folder of recorded motions; empty: none are computed.
  std::filesystem::path records;
  /// Where figures and files of other programs go.
  std::filesystem::path folder = "results/performance";
  /// >= 5. Interleaved rounds whose median counts.
  int rounds = 5;
  /// Less of everything, to try the program; its figures mean little.
  bool quick = false;
};

/// The five-storey building: time for an error of 0.1 %, beside SUNDIALS and OpenSees.
void equal_accuracy(Record& record, const Options& options);
/// A street of up to 1e5 degrees of freedom: time and memory by size.
void scale(Record& record, const Options& options);
/// A study of many histories: histories per second, and the gain of a second thread.
void suite(Record& record, const Options& options);
/// The benchmark building of MOAT_EXPERIMENTS from matrices and modes, beside a PlanBuilding of as many floors.
void superstructures(Record& record, const Options& options);
/// One history of a row of that table in this process; returns its peak of memory, bytes.
double superstructure_bytes(std::size_t row);
/// The tours through the launcher: from the command to its end, edited and unchanged, and the whole run of one.
void scripts(Record& record, const Options& options);

}  // namespace moat::performance
