#include "structures/superstructure/matrix_checks.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/dense.hpp"

namespace moat {
namespace {

std::string name_of(const NamedRows& rows, Eigen::Index row) { return rows.names[static_cast<std::size_t>(row)]; }

// Penalty constraints of a finite-element program leave numbers beside which all others lose their digits.
void check_penalties(const NamedRows& rows, const Eigen::MatrixXd& matrix) {
  std::vector<double> diagonal(static_cast<std::size_t>(matrix.rows()));
  Eigen::VectorXd::Map(diagonal.data(), matrix.rows()) = matrix.diagonal();
  std::ranges::nth_element(diagonal, diagonal.begin() + matrix.rows() / 2);
  constexpr double largest = 1e10;
  const double median = diagonal[static_cast<std::size_t>(matrix.rows() / 2)];
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    rows.check.that(matrix(i, i) <= largest * median,
                    std::string{rows.field} + " of " + name_of(rows, i) + " is " + to_text(matrix(i, i) / median) +
                        " times the median of the diagonal.",
                    "Penalty constraints leave such numbers: export with constraints Transformation.");
}

}  // namespace

Eigen::MatrixXd symmetric(const NamedRows& rows, const Eigen::MatrixXd& matrix, Diagonal diagonal,
                          std::vector<std::string>& notes) {
  constexpr double round_off = 1e-12, tolerated = 1e-6;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    rows.check.that(matrix(i, i) > 0.0 || (matrix(i, i) == 0.0 && diagonal == Diagonal::not_negative),
                    std::string{rows.field} + " of " + name_of(rows, i) + " is " + to_text(matrix(i, i)) + ".",
                    "A diagonal is positive; the order or the unit of the file may be another.");
  double worst = 0.0;
  Eigen::Index i = 0, j = 0;
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
    for (Eigen::Index row = 0; row < column; ++row) {
      if (matrix(row, column) == matrix(column, row)) continue;
      const double difference =
          std::abs(matrix(row, column) - matrix(column, row)) / std::sqrt(matrix(row, row) * matrix(column, column));
      if (difference <= worst) continue;
      worst = difference;
      i = row;
      j = column;
    }
  const std::string text = std::string{rows.field} + " is not symmetric: entry (" + name_of(rows, i) + ", " +
                           name_of(rows, j) + ") = " + to_text(matrix(i, j)) + ", transposed " + to_text(matrix(j, i)) +
                           ", " + to_text(100.0 * worst) + " % of the diagonals.";
  rows.check.that(worst <= tolerated, text, "Export the whole matrix, or one triangle of it.");
  if (worst > round_off) notes.push_back(text + " The mean is taken.");
  return 0.5 * (matrix + matrix.transpose());
}

void check_definite(const NamedRows& rows, const Eigen::MatrixXd& stiffness, std::vector<std::string>& notes) {
  check_penalties(rows, stiffness);
  const Eigen::VectorXd scale = stiffness.diagonal().cwiseSqrt().cwiseInverse();
  const EigenPairs pairs = eigen_pairs(scale.asDiagonal() * stiffness * scale.asDiagonal());
  const double smallest = pairs.values[0], round_off = 1e-12 * static_cast<double>(stiffness.rows());
  const Eigen::VectorXd shape = pairs.vectors.col(0).cwiseAbs();
  Eigen::Index largest = 0;
  shape.maxCoeff(&largest);
  const std::string where = ", largest at " + name_of(rows, largest) + ".";
  rows.check.that(
      smallest > -round_off,
      std::string{rows.field} + " is indefinite: eigenvalue " + to_text(smallest) + " of the scaled matrix" + where,
      "Its diagonal is scaled to 1. Look for a wrong sign, unit or order.");
  std::string loose;
  for (Eigen::Index i = 0; i < shape.size(); ++i)
    if (shape[i] > 0.1 * shape[largest]) loose += (loose.empty() ? "" : ", ") + name_of(rows, i);
  rows.check.that(smallest > round_off, loose + ": nothing holds them.",
                  "The smallest eigenvalue of the scaled " + std::string{rows.field} + " is " + to_text(smallest) +
                      ". Give the matrix of the building held at its base.");
  constexpr double nearly = 1e-8;
  if (smallest < nearly)
    notes.push_back(std::string{rows.field} + " is nearly singular: eigenvalue " + to_text(smallest) +
                    " of the scaled matrix" + where);
}

void check_rigid(const NamedRows& rows, const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& rigid,
                 const std::string& remedy, std::vector<std::string>& notes) {
  constexpr double round_off = 1e-9, tolerated = 1e-4, noise = 1e-6;
  const Eigen::VectorXd roots = matrix.diagonal().cwiseAbs().cwiseSqrt();
  double worst = 0.0;
  Eigen::Index at = 0;
  for (Eigen::Index motion = 0; motion < rigid.cols(); ++motion)
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      const Eigen::VectorXd terms = matrix.row(i).transpose().cwiseProduct(rigid.col(motion));
      const double least = noise * roots[i] * roots.cwiseProduct(rigid.col(motion)).cwiseAbs().maxCoeff();
      const double share = std::abs(terms.sum()) / std::max(terms.cwiseAbs().sum(), least);
      if (!(share > worst)) continue;
      worst = share;
      at = i;
    }
  const std::string text = std::string{rows.field} + ": rigid motion of base and floors strains row " +
                           name_of(rows, at) + " by " + to_text(100.0 * worst) + " %";
  rows.check.that(worst <= tolerated, text + ".", remedy);
  if (worst > round_off) notes.push_back(text + "; the rows of the base are formed from those of the floors.");
}

}  // namespace moat
