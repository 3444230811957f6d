// Shake-table tests of a building of three storeys on friction pendulums.
//
// A. Masroor, G. Mosqueda, MCEER-13-0003 (2013); Earthquake Engineering and Structural Dynamics 41 (2012) 2093. Files
// fpgm<motion>s<level>.csv hold tests on the pendulums without walls, fbgm<motion>s<level>.csv those on a fixed base.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "motions/ground_motion.hpp"

namespace moat::experiments {

inline constexpr double inch = 0.0254;  ///< m

using History = std::vector<double>;

/// Deformations of the building, m: of the isolators (all 0 on a fixed base), then drifts from the lowest storey up.
/// All are filtered by high_passed_both_ways().
struct Deformations {
  History isolators;
  std::array<History, 3> drifts;
};

struct BuffaloTest {
  std::string name;  ///< "fpgm171s2"
  bool isolated = false;
  int level = 0;          ///< of the motion, 1 to 5
  GroundMotion table;     ///< its acceleration less the mean: the table rests before and after, so that its mean is 0
  Deformations measured;  ///< The isolators' are the base channel less the displacement of the table.

  /// Levels 1, 3 and 5 identify the parameters of the model, 2 and 4 are predicted.
  [[nodiscard]] bool identifies() const { return level % 2 == 1; }
};

/// Returns the tests of a folder by their names. Throws FileError for a file of another layout.
std::vector<BuffaloTest> read_buffalo_tests(const std::filesystem::path& folder);

/// Butterworth high-pass of second order at 0.15 Hz, forwards and backwards, of a history in steps of 1/256 s. The
/// first value is taken off before, so that it starts from rest.
History high_passed_both_ways(History history);

/// Largest magnitude.
double largest(const History& history);
/// Coefficient of correlation of two histories of equal length, from -1 to 1.
double correlation(const History& a, const History& b);

}  // namespace moat::experiments
