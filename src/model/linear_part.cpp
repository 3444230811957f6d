#include "model/linear_part.hpp"

namespace moat {

void LinearPart::clear(const std::shared_ptr<const SparsityPattern>& pattern) {
  stiffness_ = damping_ = SparseMatrix{pattern};
  per_displacement_.setZero(stiffness_.size() + 1);
  per_velocity_.setZero(stiffness_.size() + 1);
  forces_at_rest_.resize(0);
}

void LinearPart::add(ElementBlock& block) {
  block.add_tangent(1.0, 0.0, stiffness_);
  block.add_tangent(0.0, 1.0, damping_);
  const Eigen::Index count = stiffness_.size();
  const Vector zero = Vector::Zero(count + 1);
  Vector at_rest = zero, all_by_one = Vector::Ones(count + 1);
  all_by_one[count] = 0.0;
  block.evaluate(zero.data(), zero.data(), at_rest.data());
  block.evaluate(all_by_one.data(), zero.data(), per_displacement_.data());
  block.evaluate(zero.data(), all_by_one.data(), per_velocity_.data());
  if ((at_rest.array() == 0.0).all()) return;
  per_displacement_ -= at_rest;
  per_velocity_ -= at_rest;
  if (forces_at_rest_.size() == 0) forces_at_rest_ = zero;
  forces_at_rest_ += at_rest;
}

void LinearPart::evaluate(const double* displacement, const double* velocity, Vector& forces) const {
  multiply(displacement, velocity, forces_at_rest_, forces);
}

void LinearPart::evaluate_rates(const double* velocity, const double* acceleration, Vector& rates) const {
  multiply(velocity, acceleration, Vector{}, rates);
}

// result := K u + C v + added, where `added` may be empty.
void LinearPart::multiply(const double* displacement, const double* velocity, const Vector& added,
                          Vector& result) const {
  const int *starts = stiffness_.column_starts().data(), *rows = stiffness_.row_indices().data();
  const double *stiffness = stiffness_.values.data(), *damping = damping_.values.data(),
               *per_displacement = per_displacement_.data(), *per_velocity = per_velocity_.data();
  const int count = stiffness_.size();
  result.resize(count + 1);
  double* __restrict sums = result.data();
  double by_ground = 0.0;
  for (int i = 0; i < count; ++i) {
    sums[i] = per_displacement[i] * displacement[i] + per_velocity[i] * velocity[i];
    by_ground += sums[i];
  }
  sums[count] = -by_ground;
  // Every pair of nodes once: the entries below the diagonal.
  for (int j = 0; j < count; ++j) {
    const double u = displacement[j], v = velocity[j];
    double sum = 0.0;
    for (int k = starts[j + 1] - 1; rows[k] > j; --k) {
      const int i = rows[k];
      const double force = stiffness[k] * (displacement[i] - u) + damping[k] * (velocity[i] - v);
      sum += force;
      sums[i] -= force;
    }
    sums[j] += sum;
  }
  if (added.size() != 0) result += added;
}

}  // namespace moat
