// Sizes of quantities that belong together.
#pragma once

#include <cmath>
#include <vector>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"
#include "model/model.hpp"

namespace moat {

/// Sizes by degree of freedom. The two translations of a diaphragm are components of one vector: the size of either is
/// that of their resultant, so that no judgement depends on the axes of the model. Every other degree of freedom stands
/// for itself.
class Resultants {
 public:
  /// The model must be complete.
  explicit Resultants(const Model& model);

  /// Returns judge(size), where size(i, component) is the size at degree of freedom i of a quantity whose components
  /// are component(0), component(1) ... On a line it is the magnitude, without cost.
  template <class Judge>
  decltype(auto) with(const Judge& judge) const {
    if (partners_.empty()) return judge([](int i, const auto& component) { return std::abs(component(i)); });
    return judge([partners = partners_.data()](int i, const auto& component) {
      const double first = component(i);
      if (partners[i] == i) return std::abs(first);
      const double second = component(partners[i]);
      return std::sqrt(first * first + second * second);
    });
  }

  /// Gershgorin's bounds row by row: sums of the sizes of a row's entries. The size of the entries between two vectors
  /// is the largest stretch of their 2x2 matrix.
  [[nodiscard]] Vector row_sums(const SparseMatrix& matrix) const;

 private:
  [[nodiscard]] int partner(int i) const { return partners_.empty() ? i : partners_[static_cast<std::size_t>(i)]; }

  std::vector<int> partners_;  // the other component, or the degree of freedom itself; empty on a line
};

}  // namespace moat
