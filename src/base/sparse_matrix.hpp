// A square sparse matrix with a fixed pattern that is assembled in place.
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <utility>
#include <vector>

namespace moat {

/// Index of the ground among degrees of freedom: a row and column that are not solved for.
inline constexpr int ground_index = -1;

/// The places of entries in a square sparse matrix: compressed columns.
struct SparsityPattern {
  int size = 0;                    ///< number of degrees of freedom
  std::vector<int> column_starts;  ///< size + 1
  std::vector<int> row_indices;    ///< ascending within each column

  /// Number of entries.
  [[nodiscard]] int nonzeros() const { return static_cast<int>(row_indices.size()); }

  /// Position of entry (row, column) in the values of a matrix; the last position where either is the ground.
  /// Throws std::out_of_range for an entry that is not in the pattern.
  [[nodiscard]] int slot(int row, int column) const;
};

/// Values on a pattern that matrices share. There is one value more than there are entries: the slot of everything that
/// couples to the ground, so that elements scatter without a test for the ground.
class SparseMatrix {
 public:
  /// Of size 0.
  SparseMatrix() : SparseMatrix{std::make_shared<const SparsityPattern>()} {}
  /// Zero. The pattern must exist.
  SparseMatrix(std::shared_ptr<const SparsityPattern> pattern)
      : values(pattern->row_indices.size() + 1, 0.0), pattern_{std::move(pattern)} {}

  /// The places of its entries.
  [[nodiscard]] const std::shared_ptr<const SparsityPattern>& pattern() const { return pattern_; }
  /// As in the pattern.
  [[nodiscard]] int size() const { return pattern_->size; }
  /// As in the pattern.
  [[nodiscard]] const std::vector<int>& column_starts() const { return pattern_->column_starts; }
  /// As in the pattern.
  [[nodiscard]] const std::vector<int>& row_indices() const { return pattern_->row_indices; }
  /// As in the pattern.
  [[nodiscard]] int nonzeros() const { return pattern_->nonzeros(); }
  /// As in the pattern.
  [[nodiscard]] int slot(int row, int column) const { return pattern_->slot(row, column); }

  /// The same matrix as Eigen sees it, without a copy.
  [[nodiscard]] Eigen::Map<const Eigen::SparseMatrix<double>> view() const {
    return {size(), size(), nonzeros(), column_starts().data(), row_indices().data(), values.data()};
  }

  std::vector<double> values;  ///< nonzeros + 1

 private:
  std::shared_ptr<const SparsityPattern> pattern_;
};

/// Collects which degrees of freedom couple.
class PatternBuilder {
 public:
  /// Size >= 0 degrees of freedom.
  explicit PatternBuilder(int size);

  /// Entries (a, a), (a, b), (b, a), (b, b); the ground is ignored.
  void couple(int a, int b);
  /// The pattern. The whole diagonal is always in it.
  [[nodiscard]] std::shared_ptr<const SparsityPattern> build();

 private:
  int size_;
  std::vector<std::pair<int, int>> pairs_;  // coupled, without the ground
};

}  // namespace moat
