#include "model/linear_part.hpp"

namespace moat {
namespace {

// result := start + K x + C y. Both matrices are symmetric: their columns are their rows.
void multiply(const SparseMatrix& pattern, const double* stiffness, const double* x, const double* damping,
              const double* y, const double* start, double* __restrict result) {
  const int *ends = pattern.column_starts.data() + 1, *rows = pattern.row_indices.data();
  int k = 0;
  for (int i = 0; i < pattern.size; ++i) {
    double sum = start[i];
    for (const int end = ends[i]; k < end; ++k) sum += stiffness[k] * x[rows[k]] + damping[k] * y[rows[k]];
    result[i] = sum;
  }
  result[pattern.size] = 0.0;
}

}  // namespace

void LinearPart::clear(const SparseMatrix& pattern) {
  stiffness_.assign(pattern.values.size(), 0.0);
  damping_.assign(pattern.values.size(), 0.0);
  zero_.setZero(pattern.size + 1);
  forces_at_rest_ = zero_;
}

void LinearPart::add(ElementBlock& block) {
  block.add_tangent(1.0, 0.0, stiffness_.data());
  block.add_tangent(0.0, 1.0, damping_.data());
  block.evaluate(zero_.data(), zero_.data(), forces_at_rest_.data());
}

void LinearPart::evaluate(const SparseMatrix& pattern, const double* displacement, const double* velocity,
                          Vector& forces) const {
  forces.resize(zero_.size());
  multiply(pattern, stiffness_.data(), displacement, damping_.data(), velocity, forces_at_rest_.data(), forces.data());
}

void LinearPart::evaluate_rates(const SparseMatrix& pattern, const double* velocity, const double* acceleration,
                                Vector& force_rates) const {
  force_rates.resize(zero_.size());
  multiply(pattern, stiffness_.data(), velocity, damping_.data(), acceleration, zero_.data(), force_rates.data());
}

}  // namespace moat
