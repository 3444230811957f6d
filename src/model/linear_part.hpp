// The elements of a model whose tangents never change, as matrices.
#pragma once

#include <memory>
#include <vector>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"
#include "model/element_block.hpp"

namespace moat {

/// Forces of all elements whose tangents never change, without a look at each of them:
///
///     f = K u + C v + f_0,   K and C symmetric;   f_0 the forces at rest
///
/// Matrices have the pattern of the model; vectors have one entry per degree of freedom, and one for the ground.
class LinearPart {
 public:
  /// Starts again, with no elements.
  void clear(const std::shared_ptr<const SparsityPattern>& pattern);
  /// Adds the elements of a block with constant tangents, which has its slots in the pattern. The block is evaluated at
  /// rest.
  void add(ElementBlock& block);

  /// K, values of the pattern.
  [[nodiscard]] const std::vector<double>& stiffness() const { return stiffness_.values; }
  /// C, values of the pattern.
  [[nodiscard]] const std::vector<double>& damping() const { return damping_.values; }

  /// forces := K u + C v + f_0, without the forces on the ground.
  void evaluate(const double* displacement, const double* velocity, Vector& forces) const;

 private:
  SparseMatrix stiffness_, damping_;
  Vector forces_at_rest_;  // empty where all are zero
};

}  // namespace moat
