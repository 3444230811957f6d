// Forces, rates and tangents of all elements of a model.
#include <algorithm>

#include "model/model.hpp"

namespace moat {

void Model::evaluate() {
  linear_part_.evaluate(trial_.displacement.data(), trial_.velocity.data(), internal_forces_);
  evaluate_changing(internal_forces_.data());
}

void Model::evaluate_elements() {
  evaluate_changing(nullptr);
  for (const std::size_t i : changing_blocks_) blocks_[i]->evaluate_rates(trial_.acceleration.data(), nullptr);
}

// The elements without constant tangents at the trial state; adds their forces unless `forces` is null.
void Model::evaluate_changing(double* forces) {
  const double step = trial_.time - state_.time;
  for (const std::size_t i : changing_blocks_) {
    blocks_[i]->begin_step(step);
    blocks_[i]->evaluate(trial_.displacement.data(), trial_.velocity.data(), forces);
    if (blocks_[i]->take_tangent_change()) ++tangent_version_;
  }
}

void Model::evaluate_rates() {
  const int count = degrees_of_freedom();
  // First the rates of forces.
  linear_part_.evaluate_rates(trial_.velocity.data(), trial_.acceleration.data(), trial_.jerk);
  double* __restrict jerk = trial_.jerk.data();
  for (const std::size_t i : changing_blocks_) blocks_[i]->evaluate_rates(trial_.acceleration.data(), jerk);
  const double* mass = masses_.data();
  for (int i = 0; i < count; ++i) jerk[i] = -jerk[i] / mass[i];
  jerk[count] = 0.0;
}

// Those of blocks_with_results_ at a motion, without their forces on nodes, which linear_part_ has.
void Model::evaluate_results(const MotionState& motion) {
  for (const std::size_t i : blocks_with_results_) {
    blocks_[i]->evaluate(motion.displacement.data(), motion.velocity.data(), nullptr);
    blocks_[i]->evaluate_rates(motion.acceleration.data(), nullptr);
  }
}

void Model::keep_results_of(const std::vector<bool>& wanted) {
  blocks_with_results_.clear();
  for (const std::size_t i : constant_blocks_)
    if (wanted[i] || keeps_energy_accounts_) blocks_with_results_.push_back(i);
}

void Model::keep_all_results() {
  if (!prepared_ || blocks_with_results_.size() == constant_blocks_.size()) return;
  blocks_with_results_ = constant_blocks_;
  evaluate_results(state_);
}

void Model::assemble_tangent(double acceleration_weight, double velocity_weight, double displacement_weight,
                             SparseMatrix& matrix) const {
  const double *stiffness = linear_part_.stiffness().data(), *damping = linear_part_.damping().data();
  double* __restrict values = matrix.values.data();
  for (int k = 0; k < matrix.nonzeros(); ++k)
    values[k] = displacement_weight * stiffness[k] + velocity_weight * damping[k];
  for (int i = 0; i < matrix.size(); ++i)
    values[diagonal_slots_[static_cast<std::size_t>(i)]] += acceleration_weight * masses_[i];
  // The entry of the ground: elements add to it, and nothing reads it.
  matrix.values.back() = 0.0;
  for (const std::size_t i : changing_blocks_) blocks_[i]->add_tangent(displacement_weight, velocity_weight, matrix);
}

void Model::linearise(SparseMatrix& stiffness, SparseMatrix& damping, Vector& forces) {
  trial_.displacement.setZero();
  trial_.velocity.setZero();
  const double *displacement = trial_.displacement.data(), *velocity = trial_.velocity.data();
  linear_part_.evaluate(displacement, velocity, forces);
  stiffness.values = linear_part_.stiffness();
  damping.values = linear_part_.damping();
  for (const std::size_t i : changing_blocks_) {
    blocks_[i]->evaluate(displacement, velocity, forces.data());
    blocks_[i]->add_tangent(1.0, 0.0, stiffness);
    blocks_[i]->add_tangent(0.0, 1.0, damping);
  }
}

UnlocatedCorners Model::find_corners(Vector& lost) const {
  lost.setZero(degrees_of_freedom() + 1);
  UnlocatedCorners corners;
  for (const std::size_t i : changing_blocks_) blocks_[i]->find_corners(corners, lost.data());
  return corners;
}

void Model::assemble_linear_stiffness(StiffnessStage stage, SparseMatrix& matrix) const {
  std::fill(matrix.values.begin(), matrix.values.end(), 0.0);
  for (const auto& block : blocks_)
    if (block->contacts() == nullptr) block->add_linear_stiffness(stage, matrix);
}

}  // namespace moat
