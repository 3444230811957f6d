// Two builds of this program in turns.
#pragma once

#include <filesystem>
#include <string>

namespace moat::performance {

struct Comparison {
  std::filesystem::path other;  ///< the program of another build
  std::string section = "equal-accuracy";
  std::filesystem::path folder = "results/performance/compare";
  int turns = 2;  ///< >= 1: 2 is A B A B
};

/// Runs the section with the other program (A) and with this one (B), in turns, and prints time of B over time of A for
/// each figure in s or ms that both have. The shortest time of all turns counts: other work on the machine only makes
/// times longer. Throws Error where a program fails or where no figure is common.
void compare(const Comparison& comparison);

}  // namespace moat::performance
