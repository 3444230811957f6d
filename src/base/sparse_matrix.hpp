// A square sparse matrix with a fixed pattern that is assembled in place.
#pragma once

#include <Eigen/SparseCore>
#include <utility>
#include <vector>

namespace moat {

/// Index of the ground among degrees of freedom: a row and column that are not solved for.
inline constexpr int ground_index = -1;

/// Compressed columns. `values` has one entry more than there are nonzeros: the slot of everything
/// that couples to the ground, so that elements scatter without a test for the ground.
struct SparseMatrix {
  int size = 0;                    ///< number of degrees of freedom
  std::vector<int> column_starts;  ///< size + 1
  std::vector<int> row_indices;    ///< ascending within each column
  std::vector<double> values;      ///< nonzeros + 1

  /// Number of entries of the pattern.
  [[nodiscard]] int nonzeros() const { return static_cast<int>(row_indices.size()); }

  /// Position of entry (row, column) in `values`; the last position where either is the ground.
  /// Throws std::out_of_range for an entry that is not in the pattern.
  [[nodiscard]] int slot(int row, int column) const;

  /// The same matrix as Eigen sees it, without a copy.
  [[nodiscard]] Eigen::Map<const Eigen::SparseMatrix<double>> view() const {
    return {size, size, nonzeros(), column_starts.data(), row_indices.data(), values.data()};
  }
};

/// Collects which degrees of freedom couple.
class PatternBuilder {
 public:
  /// Size >= 0 degrees of freedom.
  explicit PatternBuilder(int size);

  /// Entries (a, a), (a, b), (b, a), (b, b); the ground is ignored.
  void couple(int a, int b);
  /// Whether a degree of freedom was coupled to another one or to the ground.
  [[nodiscard]] bool couples(int a) const { return coupled_[static_cast<std::size_t>(a)]; }

  /// The pattern with all values zero. The whole diagonal is always in it.
  [[nodiscard]] SparseMatrix build();

 private:
  int size_;
  std::vector<bool> coupled_;
  std::vector<std::pair<int, int>> pairs_;  // coupled, without the ground
};

}  // namespace moat
