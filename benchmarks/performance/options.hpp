// How much of the benchmark is run.
#pragma once

#include <filesystem>

namespace moat::performance {

struct Options {
  /// Folder of recorded motions; empty: not given, and what needs them is left out.
  std::filesystem::path records;
  /// Where figures and charts go, and what other programs say.
  std::filesystem::path folder = "results/performance";
  /// >= 5. Interleaved rounds whose median counts.
  int rounds = 5;
  /// Fewer settings and shorter histories, to try the program; its figures mean little.
  bool quick = false;
};

}  // namespace moat::performance
