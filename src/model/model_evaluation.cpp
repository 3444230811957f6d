// Forces, rates and tangents of all elements of a model.
#include "model/model.hpp"

namespace moat {

void Model::evaluate() {
  internal_forces_.setZero(degrees_of_freedom() + 1);
  const double step = trial_.time - state_.time;
  for (const auto& block : blocks_) {
    block->begin_step(step);
    block->evaluate(trial_.displacement.data(), trial_.velocity.data(), internal_forces_.data());
    if (block->take_tangent_change()) ++tangent_version_;
  }
}

void Model::evaluate_rates() {
  const int count = degrees_of_freedom();
  // First the rates of forces.
  trial_.jerk.setZero(count + 1);
  for (const auto& block : blocks_) block->evaluate_rates(trial_.acceleration.data(), trial_.jerk.data());
  trial_.jerk.head(count).array() /= -masses_.array();
  trial_.jerk[count] = 0.0;
}

void Model::evaluate_linear_elements() {
  for (const std::size_t i : constant_blocks_) {
    blocks_[i]->evaluate(trial_.displacement.data(), trial_.velocity.data(), nullptr);
    blocks_[i]->evaluate_rates(trial_.acceleration.data(), nullptr);
  }
}

void Model::assemble_tangent(double acceleration_weight, double velocity_weight, double displacement_weight,
                             SparseMatrix& matrix) const {
  matrix.coeffs() = displacement_weight * constant_stiffness_.coeffs() + velocity_weight * constant_damping_.coeffs();
  for (int i = 0; i < degrees_of_freedom(); ++i)
    matrix.valuePtr()[diagonal_slots_[static_cast<std::size_t>(i)]] += acceleration_weight * masses_[i];
  for (const std::size_t i : changing_blocks_) blocks_[i]->add_tangent(displacement_weight, velocity_weight, matrix);
}

void Model::linearise(SparseMatrix& stiffness, SparseMatrix& damping, Vector& forces) {
  trial_.displacement.setZero();
  trial_.velocity.setZero();
  evaluate();
  forces = internal_forces_;
  assemble_tangent(0.0, 0.0, 1.0, stiffness);
  assemble_tangent(0.0, 1.0, 0.0, damping);
}

UnlocatedCorners Model::find_corners(Vector& lost) const {
  lost.setZero(degrees_of_freedom() + 1);
  UnlocatedCorners corners;
  for (const std::size_t i : changing_blocks_) blocks_[i]->find_corners(corners, lost.data());
  return corners;
}

SparseMatrix Model::linear_stiffness(StiffnessStage stage) const {
  SparseMatrix matrix = zero_matrix();
  for (const auto& block : blocks_)
    if (block->contacts() == nullptr) block->add_linear_stiffness(stage, matrix);
  return matrix;
}

}  // namespace moat
