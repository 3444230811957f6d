// Modes of a building from files.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace moat {

/// Modes of a superstructure held at its base.
struct ModesFromFile {
  Eigen::VectorXd eigenvalues{};     ///< w^2, 1/s^2, one for each mode
  Eigen::MatrixXd shapes{};          ///< a row for each freedom, a column for each mode; as in the file
  std::vector<double> ratios{};      ///< damping ratios, one for each mode; empty where the file has none
  std::vector<std::string> names{};  ///< of the rows, "floor 1 x"; empty where the file has none
  std::vector<std::string> notes{};  ///< remarks about the files, sentences
};

/// Reads two files:
///
/// - `modes.csv`, a table `mode,period [s]` or `mode,eigenvalue [1/s2]`, and perhaps `ratio`. Modes are numbered
/// from 1.
/// - `shapes.csv`, a row for each freedom and a column for each mode, as read_matrix() takes them; or a table
///   `mode,floor,x [m],y [m],rotation [rad]`, on a line without y and rotation. Floors are 1, 2, ... or "floor 1", ...;
///   `floors` gives other names, from the lowest floor up: {"Story1", "Story2"}. They have one order in all modes.
///
/// Throws FileError naming file, line and remedy: modes that are not numbered 1, 2, ..., a period or eigenvalue that is
/// not > 0, a ratio outside [0, 1), another count of modes in the second file, a floor that is missing or unknown.
ModesFromFile read_modes(const std::filesystem::path& modes, const std::filesystem::path& shapes,
                         const std::vector<std::string>& floors = {});

}  // namespace moat
