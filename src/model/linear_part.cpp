#include "model/linear_part.hpp"

namespace moat {

void LinearPart::clear(const std::shared_ptr<const SparsityPattern>& pattern) {
  stiffness_ = damping_ = SparseMatrix{pattern};
  forces_at_rest_.resize(0);
}

void LinearPart::add(ElementBlock& block) {
  block.add_tangent(1.0, 0.0, stiffness_);
  block.add_tangent(0.0, 1.0, damping_);
  const Vector at_rest = Vector::Zero(stiffness_.size() + 1);
  if (forces_at_rest_.size() == 0) forces_at_rest_ = at_rest;
  block.evaluate(at_rest.data(), at_rest.data(), forces_at_rest_.data());
  if ((forces_at_rest_.array() == 0.0).all()) forces_at_rest_.resize(0);
}

void LinearPart::evaluate(const double* displacement, const double* velocity, Vector& forces) const {
  const int *starts = stiffness_.column_starts().data(), *rows = stiffness_.row_indices().data();
  const double *stiffness = stiffness_.values.data(), *damping = damping_.values.data(),
               *at_rest = forces_at_rest_.size() == 0 ? nullptr : forces_at_rest_.data();
  forces.resize(stiffness_.size() + 1);
  double* __restrict result = forces.data();
  // Columns of symmetric matrices are their rows.
  const int count = stiffness_.size();
  for (int i = 0; i < count; ++i) {
    double sum = at_rest == nullptr ? 0.0 : at_rest[i];
    for (int k = starts[i]; k < starts[i + 1]; ++k)
      sum += stiffness[k] * displacement[rows[k]] + damping[k] * velocity[rows[k]];
    result[i] = sum;
  }
  result[count] = 0.0;
}

}  // namespace moat
