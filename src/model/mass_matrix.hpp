// The mass matrix of a model.
#pragma once

#include <Eigen/Cholesky>
#include <span>
#include <vector>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"
#include "model/couplings.hpp"

namespace moat {

/// A diagonal, and dense symmetric blocks where degrees of freedom are coupled by their masses: those of a building in
/// generalised coordinates, for example, with one another and with its base. Its two operations are multiply() and
/// solve(); both cost one multiplication or division per degree of freedom where there is no block.
class MassMatrix {
 public:
  /// Appends a degree of freedom with a mass, kg, that is coupled with no other.
  void append(double mass) { diagonal_.push_back(mass); }
  /// Adds a symmetric matrix, kg, to the rows and columns of these degrees of freedom, which are different. Returns
  /// whether the matrix is positive definite then; it stays as it was where it would not be.
  [[nodiscard]] bool add(std::span<const int> degrees_of_freedom, const Eigen::MatrixXd& masses);

  /// The diagonal, kg.
  [[nodiscard]] Eigen::Map<const Vector> diagonal() const {
    return {diagonal_.data(), static_cast<Eigen::Index>(diagonal_.size())};
  }
  /// Whether no degrees of freedom are coupled.
  [[nodiscard]] bool is_diagonal() const { return blocks_.empty(); }
  /// The rows of the block of a row, ascending; empty where it is coupled with no other.
  [[nodiscard]] std::span<const int> coupled_with(int row) const;
  /// The entry of a row and a column, kg.
  [[nodiscard]] double at(int row, int column) const;
  /// result := M values; two arrays of the size of the matrix.
  void multiply(const double* values, double* result) const;
  /// values := M^-1 values.
  void solve(double* values) const;
  /// a' M^-1 b of vectors that are zero but for these degrees of freedom, 1/kg: the change of the velocity along a
  /// under a unit impulse along b.
  [[nodiscard]] double mobility(std::span<const int> degrees_of_freedom, std::span<const double> a,
                                std::span<const double> b) const;
  /// Bounds of the accelerations, m/s^2, of all degrees of freedom under forces of at most these sizes, N: |M^-1|
  /// sizes.
  [[nodiscard]] Vector largest_accelerations(const Vector& sizes) const;

  /// Adds the couplings of all blocks.
  void add_couplings(Couplings& couplings) const;
  /// Adds weight * M to a matrix with the entries of add_couplings().
  void add_to(double weight, SparseMatrix& matrix) const;

 private:
  struct Block {
    std::vector<int> rows;   // ascending
    Eigen::MatrixXd masses;  // all of these rows
    Eigen::LLT<Eigen::MatrixXd> factors;

    [[nodiscard]] Vector gathered(const double* values) const;
  };

  std::vector<double> diagonal_;
  std::vector<Block> blocks_;  // without common rows
};

}  // namespace moat
