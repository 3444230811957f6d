// Checks of the matrices of a building, with numbers.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "base/check.hpp"

namespace moat {

/// A square matrix and the names of its rows: "floor 3 rotation".
struct NamedRows {
  const Check& check;                     ///< names the building
  std::string_view field;                 ///< "stiffness"
  const std::vector<std::string>& names;  ///< of the rows
};

/// Whether a diagonal of zeros is allowed, as that of dampers along x alone.
enum class Diagonal { positive, not_negative };

/// Returns the mean of the matrix and its transpose. Throws InputError where they differ by more than 1e-6 of the
/// diagonals, and for a diagonal that is not allowed; a smaller difference that is no round-off adds a note.
Eigen::MatrixXd symmetric(const NamedRows& rows, const Eigen::MatrixXd& matrix, Diagonal diagonal,
                          std::vector<std::string>& notes);

/// Throws InputError for a matrix, with a positive diagonal, that is not positive definite; one that is nearly singular
/// adds a note.
void check_definite(const NamedRows& rows, const Eigen::MatrixXd& stiffness, std::vector<std::string>& notes);

/// Throws InputError where motions that must strain nothing, the columns of `rigid`, have forces above 1e-4 of their
/// terms in a row; above 1e-9 it adds a note. Entries of round-off are no terms.
void check_rigid(const NamedRows& rows, const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& rigid,
                 const std::string& remedy, std::vector<std::string>& notes);

}  // namespace moat
