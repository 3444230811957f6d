// The elements of a model whose tangents never change, as matrices.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/copyable_pointer.hpp"
#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"
#include "model/element_block.hpp"

namespace moat {

/// Forces of all elements whose tangents never change, without a look at each of them:
///
///     f = K u + C v + f_0,   K and C symmetric;   f_0 the forces at rest
///
/// A product is formed from differences, as the elements form them, so that a stiff link between nodes that move
/// together has no more round-off here than there:
///
///     f_i = sum_j K_ij (u_j - u_i) + k_i u_i + ...,   k_i the force on node i where all nodes are displaced by 1
///
/// Matrices have the pattern of the model; vectors have one entry per degree of freedom, and one for the ground.
class LinearPart {
 public:
  /// No elements; of use when assigned to.
  LinearPart() = default;
  /// Of the elements in those blocks that have constant tangents. They have their slots in the pattern, and are
  /// evaluated.
  LinearPart(const std::shared_ptr<const SparsityPattern>& pattern,
             std::span<const CopyablePointer<ElementBlock>> blocks);

  /// K, values of the pattern.
  [[nodiscard]] const std::vector<double>& stiffness() const { return stiffness_.values; }
  /// C, values of the pattern.
  [[nodiscard]] const std::vector<double>& damping() const { return damping_.values; }

  /// forces := K u + C v + f_0. The last entry is the sum of the forces on the ground, for a model on a line.
  void evaluate(const double* displacement, const double* velocity, Vector& forces) const;
  /// The rates of these forces: rates := K v + C a, the last entry as above.
  void evaluate_rates(const double* velocity, const double* acceleration, Vector& rates) const;

 private:
  void find_pairs();
  void multiply(const double* displacement, const double* velocity, double* sums) const;

  // Two degrees of freedom with their entries of the matrices.
  struct Pair {
    int first, second;
    double stiffness, damping;
  };

  SparseMatrix stiffness_, damping_;
  std::vector<Pair> pairs_;                 // the entries below the diagonal
  Vector forces_at_rest_;                   // empty where all are zero
  Vector per_displacement_, per_velocity_;  // the forces where all nodes are displaced by 1, or move with 1
};

}  // namespace moat
