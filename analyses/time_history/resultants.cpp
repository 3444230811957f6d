#include "analyses/time_history/resultants.hpp"

#include <algorithm>
#include <array>

namespace moat {
namespace {

// The entries between two quantities of one or two components.
struct Entries {
  std::array<double, 4> values{};

  // The largest singular value.
  [[nodiscard]] double stretch() const {
    const auto [a, b, c, d] = values;
    const double squares = a * a + b * b + c * c + d * d, determinant = a * d - b * c;
    const double difference = std::sqrt(std::max(squares * squares - 4.0 * determinant * determinant, 0.0));
    return std::sqrt(0.5 * (squares + difference));
  }
};

}  // namespace

Resultants::Resultants(const Model& model) {
  if (!model.is_plan()) return;
  for (int i = 0; i < model.degrees_of_freedom(); ++i) partners_.push_back(i);
  for (const PlacedDiaphragm& diaphragm : model.diaphragms()) {
    partners_[static_cast<std::size_t>(diaphragm.id.x.index)] = diaphragm.id.y.index;
    partners_[static_cast<std::size_t>(diaphragm.id.y.index)] = diaphragm.id.x.index;
  }
}

Vector Resultants::row_sums(const SparseMatrix& matrix) const {
  Vector sums = Vector::Zero(matrix.rows());
  const auto first_of = [&](int i) { return std::min(i, partner(i)); };
  std::vector<Entries> of_row(static_cast<std::size_t>(matrix.rows()));
  std::vector<int> rows;
  for (int first = 0; first < matrix.rows(); ++first) {
    if (first_of(first) != first) continue;
    rows.clear();
    const int second = partner(first);
    for (int column = first; column <= std::max(first, second); column += std::max(second - first, 1)) {
      for (SparseMatrix::InnerIterator entry{matrix, column}; entry; ++entry) {
        const int row = static_cast<int>(entry.row()), head = first_of(row);
        of_row[static_cast<std::size_t>(head)].values[(row != head ? 2 : 0) + (column != first ? 1 : 0)] =
            entry.value();
        rows.push_back(head);
      }
    }
    for (const int row : rows) {
      Entries& entries = of_row[static_cast<std::size_t>(row)];
      sums[row] += entries.stretch();
      entries = {};
    }
  }
  for (int i = 0; i < matrix.rows(); ++i) sums[i] = sums[first_of(i)];
  return sums;
}

}  // namespace moat
