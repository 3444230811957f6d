// The questions of the benchmark, one function each.
#pragma once

#include <filesystem>

#include "measuring/record.hpp"

namespace moat::performance {

struct Options {
  /// Folder of recorded motions; empty: none are computed.
  std::filesystem::path records;
  /// Where figures, charts and messages of other programs go.
  std::filesystem::path folder = "results/performance";
  /// >= 5. Interleaved rounds whose median counts.
  int rounds = 5;
  /// Fewer settings and shorter histories, to try the program; its figures mean little.
  bool quick = false;
};

/// The five-storey building: time for 0.1 % and 1 % error, beside SUNDIALS, Octave and loops written by hand.
void equal_accuracy(Record& record, const Options& options);
/// The general path beside a loop written for one building, step by step; the cost of observers.
void overhead(Record& record, const Options& options);
/// A tower in plan beside a loop written for it, step by step.
void plan_cost(Record& record, const Options& options);
/// A street of up to a million degrees of freedom: time and memory by size, and an iteration beside streaming memory.
void scale(Record& record, const Options& options);
/// A study of many histories: histories per second and parallel efficiency.
void suite(Record& record, const Options& options);
/// The tours through the launcher: from the command to its end, edited and unchanged.
void scripts(Record& record, const Options& options);

}  // namespace moat::performance
