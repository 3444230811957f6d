// Operations on dense matrices. Eigen's solvers and products cost seconds of compile time in every file that has them:
// here they are compiled once. A symmetric matrix counts by its lower triangle.
#pragma once

#include <Eigen/Core>

namespace moat {

/// Eigenvalues, ascending, and an eigenvector in each column.
struct EigenPairs {
  /// Eigenvalues, rising.
  Eigen::VectorXd values;
  /// Eigenvectors, one per column.
  Eigen::MatrixXd vectors;
};

/// Returns those of a symmetric matrix, with vectors of unit length.
EigenPairs eigen_pairs(const Eigen::MatrixXd& symmetric);
/// Returns those of K x = w^2 M x, symmetric K and positive definite M: w^2, and vectors with x' M x = 1.
EigenPairs eigen_pairs(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass);
/// Returns those of a symmetric matrix with these entries on and beside its diagonal.
Eigen::VectorXd eigenvalues_of_tridiagonal(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside);
/// Returns the largest absolute value of the eigenvalues of a square matrix.
double spectral_radius(const Eigen::MatrixXd& matrix);
/// Returns whether a symmetric matrix is positive definite.
bool is_definite(const Eigen::MatrixXd& symmetric);
/// Returns A^-1 B; A is positive definite.
Eigen::MatrixXd solve_definite(const Eigen::MatrixXd& definite, const Eigen::MatrixXd& right_hand_sides);
/// Returns A^-1/2; A is positive definite.
Eigen::MatrixXd inverse_root(const Eigen::MatrixXd& definite);
/// Returns exp(A) of a square matrix.
Eigen::MatrixXd exponential(const Eigen::MatrixXd& matrix);
/// Returns A B.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// Returns A' M B.
Eigen::MatrixXd projected(const Eigen::MatrixXd& a, const Eigen::MatrixXd& m, const Eigen::MatrixXd& b);

}  // namespace moat
