#include "solvers/dense.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

namespace moat {

using Eigen::MatrixXd, Eigen::VectorXd;

EigenPairs eigen_pairs(const MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver{symmetric};
  return {solver.eigenvalues(), solver.eigenvectors()};
}

EigenPairs eigen_pairs(const MatrixXd& stiffness, const MatrixXd& mass) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver{stiffness, mass};
  return {solver.eigenvalues(), solver.eigenvectors()};
}

VectorXd eigenvalues_of_tridiagonal(const VectorXd& diagonal, const VectorXd& beside) {
  Eigen::SelfAdjointEigenSolver<MatrixXd> solver;
  return solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly).eigenvalues();
}

double spectral_radius(const MatrixXd& matrix) { return matrix.eigenvalues().cwiseAbs().maxCoeff(); }

bool is_definite(const MatrixXd& symmetric) { return symmetric.llt().info() == Eigen::Success; }

MatrixXd solve_definite(const MatrixXd& definite, const MatrixXd& right_hand_sides) {
  return definite.llt().solve(right_hand_sides);
}

MatrixXd inverse_root(const MatrixXd& definite) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>{definite}.operatorInverseSqrt();
}

MatrixXd exponential(const MatrixXd& matrix) { return matrix.exp(); }

MatrixXd product(const MatrixXd& a, const MatrixXd& b) { return a * b; }

MatrixXd projected(const MatrixXd& a, const MatrixXd& m, const MatrixXd& b) { return a.transpose() * m * b; }

}  // namespace moat
