#include "solvers/modes.hpp"

#include <Spectra/SymEigsShiftSolver.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/check.hpp"
#include "base/error.hpp"
#include "solvers/dense.hpp"
#include "solvers/factorisation.hpp"

namespace moat {
namespace {

constexpr int largest_dense_size = 200;

// A = M^-1/2 K M^-1/2 has the eigenvalues omega^2 and is symmetric.
SparseMatrix mass_scaled(const SparseMatrix& stiffness, const Vector& root_mass) {
  const auto per_root_mass = root_mass.cwiseInverse().asDiagonal();
  return per_root_mass * stiffness * per_root_mass;
}

// Spectra's y = (A - shift I)^-1 x with our factorisation.
class ShiftedInverse {
 public:
  using Scalar = double;

  explicit ShiftedInverse(const SparseMatrix& matrix) : matrix_{matrix} {}

  Eigen::Index rows() const { return matrix_.rows(); }
  Eigen::Index cols() const { return matrix_.cols(); }
  void set_shift(double shift) {
    SparseMatrix shifted = matrix_;
    shifted.diagonal().array() -= shift;
    if (!factorisation_.factorise(shifted)) throw Error{"modal analysis: the shifted stiffness matrix is singular"};
  }
  void perform_op(const double* x, double* y) const {
    work_ = Eigen::Map<const Vector>{x, rows()};
    factorisation_.solve(work_);
    Eigen::Map<Vector>{y, rows()} = work_;
  }

 private:
  const SparseMatrix& matrix_;
  Factorisation factorisation_;
  mutable Vector work_;
};

double largest_diagonal(const SparseMatrix& matrix) { return std::max(matrix.diagonal().maxCoeff(), 0.0); }

EigenPairs solve_sparse(const SparseMatrix& matrix, int count) {
  ShiftedInverse inverse{matrix};
  // A shift slightly below zero keeps rigid-body modes solvable.
  const double shift = -1e-6 * largest_diagonal(matrix);
  const int subspace = std::min(static_cast<int>(matrix.rows()), std::max(2 * count + 10, 30));
  Spectra::SymEigsShiftSolver<ShiftedInverse> solver{inverse, count, subspace, shift};
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-12, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) throw Error{"modal analysis: Spectra did not converge"};
  return {solver.eigenvalues(), solver.eigenvectors()};
}

void check_count(const SparseMatrix& stiffness, int count) {
  Check{"modal analysis", ""}.between("number of modes", count, 1, static_cast<int>(stiffness.rows()), "1",
                                      "A structure has as many modes as degrees of freedom.");
}

std::vector<Mode> modes_of(const EigenPairs& pairs, int count, double largest_eigenvalue) {
  // The eigenvalue of a rigid-body mode is round-off of the largest ones, of either sign.
  const double round_off = 16.0 * std::numeric_limits<double>::epsilon() * largest_eigenvalue;
  std::vector<Mode> modes;
  for (int i = 0; i < count; ++i) {
    const double eigenvalue = pairs.values[i] > round_off ? pairs.values[i] : 0.0;
    modes.push_back({std::sqrt(eigenvalue), pairs.vectors.col(i)});
  }
  return modes;
}

}  // namespace

double Mode::period() const {
  return angular_frequency > 0.0 ? 2.0 * std::numbers::pi / angular_frequency : std::numeric_limits<double>::infinity();
}

std::vector<Mode> slowest_modes(const SparseMatrix& stiffness, const Vector& mass, int count) {
  check_count(stiffness, count);
  const Vector root_mass = mass.cwiseSqrt();
  const SparseMatrix scaled = mass_scaled(stiffness, root_mass);
  const bool dense = scaled.rows() <= largest_dense_size || count > scaled.rows() / 2;
  EigenPairs pairs = dense ? eigen_pairs(Eigen::MatrixXd{scaled}) : solve_sparse(scaled, count);
  pairs.vectors.array().colwise() /= root_mass.array();
  return modes_of(pairs, count, largest_diagonal(scaled));
}

std::vector<Mode> slowest_modes(const SparseMatrix& stiffness, const SparseMatrix& mass, int count) {
  const SparseMatrix pruned = mass.pruned();
  if (pruned.nonZeros() == pruned.rows()) return slowest_modes(stiffness, Vector{pruned.diagonal()}, count);
  check_count(stiffness, count);
  const EigenPairs pairs = eigen_pairs(Eigen::MatrixXd{stiffness}, Eigen::MatrixXd{pruned});
  return modes_of(pairs, count, pairs.values.maxCoeff());
}

}  // namespace moat
