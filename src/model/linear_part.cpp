#include "model/linear_part.hpp"

#include <utility>

namespace moat {

LinearPart::LinearPart(const std::shared_ptr<const SparsityPattern>& pattern,
                       std::span<const CopyablePointer<ElementBlock>> blocks)
    : stiffness_{pattern}, damping_{pattern} {
  const Eigen::Index count = stiffness_.size();
  const Vector zero = Vector::Zero(count + 1);
  Vector at_rest = zero, all_by_one = Vector::Ones(count + 1);
  all_by_one[count] = 0.0;
  per_displacement_ = per_velocity_ = zero;
  for (const auto& block : blocks) {
    if (!block->constant_tangent()) continue;
    block->add_tangent(1.0, 0.0, stiffness_);
    block->add_tangent(0.0, 1.0, damping_);
    block->evaluate(zero.data(), zero.data(), at_rest.data());
    block->evaluate(all_by_one.data(), zero.data(), per_displacement_.data());
    block->evaluate(zero.data(), all_by_one.data(), per_velocity_.data());
  }
  find_pairs();
  if ((at_rest.array() == 0.0).all()) return;
  per_displacement_ -= at_rest;
  per_velocity_ -= at_rest;
  forces_at_rest_ = std::move(at_rest);
}

void LinearPart::find_pairs() {
  const std::vector<int>&starts = stiffness_.column_starts(), &rows = stiffness_.row_indices();
  const std::vector<double>&stiffness = stiffness_.values, &damping = damping_.values;
  for (int column = 0; column < stiffness_.size(); ++column)
    for (auto k = static_cast<std::size_t>(starts[static_cast<std::size_t>(column)]);
         k < static_cast<std::size_t>(starts[static_cast<std::size_t>(column) + 1]); ++k)
      if (rows[k] > column && (stiffness[k] != 0.0 || damping[k] != 0.0))
        pairs_.push_back({column, rows[k], stiffness[k], damping[k]});
}

void LinearPart::evaluate(const double* displacement, const double* velocity, Vector& forces) const {
  forces.resize(stiffness_.size() + 1);
  multiply(displacement, velocity, forces.data());
  if (forces_at_rest_.size() != 0) forces += forces_at_rest_;
}

void LinearPart::evaluate_rates(const double* velocity, const double* acceleration, Vector& rates) const {
  rates.resize(stiffness_.size() + 1);
  multiply(velocity, acceleration, rates.data());
}

// sums := K u + C v
void LinearPart::multiply(const double* displacement, const double* velocity, double* __restrict sums) const {
  const int count = stiffness_.size();
  const double *per_displacement = per_displacement_.data(), *per_velocity = per_velocity_.data();
  double by_ground = 0.0;
  for (int i = 0; i < count; ++i) {
    sums[i] = per_displacement[i] * displacement[i] + per_velocity[i] * velocity[i];
    by_ground += sums[i];
  }
  sums[count] = -by_ground;
  for (const Pair& pair : pairs_) {
    const double force = pair.stiffness * (displacement[pair.second] - displacement[pair.first]) +
                         pair.damping * (velocity[pair.second] - velocity[pair.first]);
    sums[pair.first] += force;
    sums[pair.second] -= force;
  }
}

}  // namespace moat
