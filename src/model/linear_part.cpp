#include "model/linear_part.hpp"

namespace moat {

void LinearPart::clear(const SparseMatrix& pattern) {
  stiffness_.assign(pattern.values.size(), 0.0);
  damping_.assign(pattern.values.size(), 0.0);
  forces_at_rest_.setZero(pattern.size + 1);
}

void LinearPart::add(ElementBlock& block) {
  block.add_tangent(1.0, 0.0, stiffness_.data());
  block.add_tangent(0.0, 1.0, damping_.data());
  const Vector at_rest = Vector::Zero(forces_at_rest_.size());
  block.evaluate(at_rest.data(), at_rest.data(), forces_at_rest_.data());
}

void LinearPart::evaluate(const SparseMatrix& pattern, const double* displacement, const double* velocity,
                          Vector& forces) const {
  const int *starts = pattern.column_starts.data(), *rows = pattern.row_indices.data();
  const double *stiffness = stiffness_.data(), *damping = damping_.data(), *at_rest = forces_at_rest_.data();
  forces.resize(forces_at_rest_.size());
  double* __restrict result = forces.data();
  // Columns of symmetric matrices are their rows.
  for (int i = 0; i < pattern.size; ++i) {
    double sum = at_rest[i];
    for (int k = starts[i]; k < starts[i + 1]; ++k)
      sum += stiffness[k] * displacement[rows[k]] + damping[k] * velocity[rows[k]];
    result[i] = sum;
  }
  result[pattern.size] = 0.0;
}

}  // namespace moat
