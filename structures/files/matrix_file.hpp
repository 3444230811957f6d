// Matrices with the units of their entries, from files or from a script.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "base/required.hpp"

namespace moat {

/// Layout of a file with a matrix.
enum class MatrixFormat {
  detect,         ///< by the content of the file, never by its name
  csv,            ///< a row in every line, separated by commas, semicolons or tabs; names in the first row and column
  matrix_market,  ///< coordinate or array, real or integer, general or symmetric
  text,           ///< a row in every line, separated by blanks: printA of OpenSees, savetxt of NumPy
};

/// The units in which the entries of a matrix are written. In a matrix of a building a translation and a rotation meet:
///
///                                  translations     translation, rotation     rotations
///     stiffness (damping: times s) force/length     force                     force length
///     mass                         mass             mass length               mass length^2
///
///     {.force = kN, .length = m}        kN/m, kN, kN m; as a mass t, t m, t m^2
///     {.length = m, .mass = tonne}      t, t m, t m^2
struct MatrixUnits {
  /// > 0 N; for masses only, it may be left out where mass is given.
  Force force{};
  Required<Length> length;  ///< > 0 m
  /// > 0 kg; left out: force s^2/length. N and mm make tonnes.
  Mass mass{};
  MatrixFormat format = MatrixFormat::detect;  ///< of a file; without meaning for a matrix of a script
};

/// A square matrix in units of its own. Its entries become SI when the freedoms of its rows are known.
struct MatrixInUnits {
  Eigen::MatrixXd values{};          ///< as written, in these units
  double force = 0.0;                ///< N: the unit of force; 0 where only that of mass was given
  double length = 1.0;               ///< m: the unit of length
  double mass = 1.0;                 ///< kg: the unit of mass
  std::vector<std::string> names{};  ///< of rows and columns, such as "floor 1 x"; empty where the file has none
  std::string source{};              ///< path of the file; empty for a matrix of a script
  std::vector<std::string> notes{};  ///< remarks about the file, sentences
};

/// Returns a matrix that a script has made. Throws InputError for a unit that is left out or not > 0, or a matrix that
/// is empty, not square or not finite.
MatrixInUnits in_units(Eigen::MatrixXd values, const MatrixUnits& units);

/// Reads a square matrix and notes the file (base/files_read.hpp):
///
///     const MatrixInUnits stiffness = read_matrix("stiffness.csv", {.force = kN, .length = m});
///
/// - CSV: n lines of n numbers, separated by commas, semicolons or tabs. A first row and a first column may have names.
/// - Matrix Market, `%%MatrixMarket matrix coordinate|array real|integer general|symmetric`.
/// - Text: n lines of n numbers, separated by blanks.
///
/// Blank lines, comments (#, %, //) and one line of words before the numbers are allowed; so are exponents with D.
/// A note says when no number has more than 6 digits: these spoil the long periods of a stiff building, in frames of
/// twelve storeys by 1e-4.
///
/// Throws InputError for a unit that is left out or not > 0, and FileError naming file, line and mistake. Mistakes are
/// a line with another count of numbers than the first, a matrix that is not square, anything that is no number, and a
/// decimal comma. Refused are also names of rows that differ from the columns', an entry that is given twice, and
/// matrices that are complex, patterns or skew.
MatrixInUnits read_matrix(const std::filesystem::path& file, const MatrixUnits& units);

}  // namespace moat
