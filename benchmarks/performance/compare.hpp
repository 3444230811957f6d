// Two builds of this program in turns.
#pragma once

#include <filesystem>
#include <string>

namespace moat::performance {

struct Comparison {
  std::filesystem::path other;  ///< the program of another build
  std::string section = "equal-accuracy";
  std::filesystem::path folder = "results/performance/compare";
  int turns = 2;        ///< >= 1: 2 is A B A B
  double bound = 1.05;  ///< ratio beyond which a row is slower
};

/// Runs the section in the other program (A) and in this one (B), in turns, and prints time of B over time of A for
/// each figure in s, ms, us or ns that both have. The shortest time of all turns counts: other work on the machine only
/// makes times longer. FOLDER/comparison.json has the numbers. Returns the number of figures of moat beyond the bound.
/// Throws Error where a program fails or where no figure is common.
int compare(const Comparison& comparison);

}  // namespace moat::performance
