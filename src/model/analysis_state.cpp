#include "model/analysis_state.hpp"

#include <algorithm>
#include <limits>

#include "base/error.hpp"

namespace moat {

AnalysisState::AnalysisState(const Model& model)
    : model_{&model}, additions_{model.additions()}, motion_{model.initial_motion()}, trial_{motion_} {
  constant_stiffness_ = constant_damping_ = model.zero_matrix();
  const GroundColumns influence = model.ground_influence();
  ground_inertia_.resize(model.degrees_of_freedom(), 3);
  for (const auto& [column, values] : {std::pair{0, influence.x}, {1, influence.y}, {2, influence.z}})
    model.mass_matrix().multiply(values, ground_inertia_.col(column).data());
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const ElementBlock& block = *model.blocks()[b];
    elements_.emplace_back(block.make_states(constant_stiffness_));
    const BlockKind kind = block.kind();
    (kind.constant_tangent ? constant_blocks_ : changing_blocks_).push_back(b);
    if (kind.has_regimes) blocks_with_regimes_.push_back(b);
    if (kind.contacts) blocks_with_contacts_.push_back(b);
  }
  // Forces and states of all elements belong to the initial motion.
  evaluate();
  evaluate_rates();
  for (const auto& elements : elements_) elements->commit(0.0, WorkRule::mean_force);
  trial_ = motion_;
  committed_forces_ = internal_forces_;
  for (const std::size_t b : constant_blocks_) {
    elements_[b]->add_tangent(1.0, 0.0, constant_stiffness_);
    elements_[b]->add_tangent(0.0, 1.0, constant_damping_);
  }
}

double AnalysisState::value_of_other(const Vector& values, NodeId node) const {
  if (node == ground) return 0.0;
  const std::span<const MotionShare> shares = model_->shares(node);
  if (node.is_follower()) {
    double sum = 0.0;
    for (const MotionShare& share : shares) sum += share.weight * values[share.node.index];
    return sum;
  }
  throw InputError{"AnalysisState: the node \"" + std::string{model_->node_name(node)} +
                   "\" was added after this state was made. Make a new analysis of the model."};
}

void AnalysisState::evaluate() {
  internal_forces_.setZero(model_->degrees_of_freedom() + 1);
  const double step = trial_.time - motion_.time;
  bool changed = false;
  for (const auto& elements : elements_)
    changed |= elements->evaluate(step, trial_.displacement.data(), trial_.velocity.data(), internal_forces_.data());
  if (changed) ++tangent_version_;
}

void AnalysisState::evaluate_rates() {
  const int count = model_->degrees_of_freedom();
  // First the rates of forces.
  trial_.jerk.setZero(count + 1);
  for (const auto& elements : elements_) elements->evaluate_rates(trial_.acceleration.data(), trial_.jerk.data());
  model_->mass_matrix().solve(trial_.jerk.data());
  trial_.jerk.head(count) *= -1.0;
  trial_.jerk[count] = 0.0;
}

void AnalysisState::evaluate_linear_elements() {
  const double step = trial_.time - motion_.time;
  for (const std::size_t b : constant_blocks_) {
    elements_[b]->evaluate(step, trial_.displacement.data(), trial_.velocity.data(), nullptr);
    elements_[b]->evaluate_rates(trial_.acceleration.data(), nullptr);
  }
}

void AnalysisState::balance(GroundVector ground_acceleration) {
  const int count = model_->degrees_of_freedom();
  const GroundColumns influence = model_->ground_influence();
  trial_.acceleration.head(count) = internal_forces_.head(count);
  model_->mass_matrix().solve(trial_.acceleration.data());
  for (int i = 0; i < count; ++i)
    trial_.acceleration[i] = -trial_.acceleration[i] - influence.times(ground_acceleration, i);
}

void AnalysisState::balance_committed_state(GroundVector ground_acceleration) {
  trial_ = motion_;
  evaluate();
  balance(ground_acceleration);
  evaluate_rates();
  commit();
}

void AnalysisState::linearise(SparseMatrix& stiffness, SparseMatrix& damping, Vector& forces) {
  trial_.displacement.setZero();
  trial_.velocity.setZero();
  evaluate();
  forces = internal_forces_;
  assemble_tangent(0.0, 0.0, 1.0, stiffness);
  assemble_tangent(0.0, 1.0, 0.0, damping);
}

void AnalysisState::assemble_tangent(double acceleration_weight, double velocity_weight, double displacement_weight,
                                     SparseMatrix& matrix) const {
  matrix.coeffs() = displacement_weight * constant_stiffness_.coeffs() + velocity_weight * constant_damping_.coeffs();
  if (acceleration_weight != 0.0) model_->mass_matrix().add_to(acceleration_weight, matrix);
  for (const std::size_t b : changing_blocks_) elements_[b]->add_tangent(displacement_weight, velocity_weight, matrix);
}

UnlocatedCorners AnalysisState::find_corners(Vector& lost) const {
  lost.setZero(model_->degrees_of_freedom() + 1);
  UnlocatedCorners corners;
  for (const std::size_t b : changing_blocks_) elements_[b]->find_corners(corners, lost.data());
  return corners;
}

void AnalysisState::commit(WorkRule rule) {
  const double step = trial_.time - motion_.time;
  std::swap(motion_, trial_);
  committed_forces_.swap(internal_forces_);
  for (const auto& elements : elements_) elements->commit(step, rule);
}

double AnalysisState::kinetic_energy() const {
  const Eigen::Index count = model_->degrees_of_freedom();
  const MassMatrix& mass = model_->mass_matrix();
  if (mass.is_diagonal()) return 0.5 * mass.diagonal().dot(motion_.velocity.head(count).cwiseAbs2());
  Vector momentum{count};
  mass.multiply(motion_.velocity.data(), momentum.data());
  return 0.5 * momentum.dot(motion_.velocity.head(count));
}

void AnalysisState::start_energy_accounts() {
  keeps_energy_accounts_ = true;
  for (const auto& elements : elements_) elements->start_energy_accounts();
}

void AnalysisState::return_to_committed_state() {
  trial_ = motion_;
  evaluate();
  evaluate_rates();
}

RegimeScan AnalysisState::scan_regimes(double step, double aim) const {
  RegimeScan scan;
  for (const std::size_t b : blocks_with_regimes_) elements_[b]->scan(step, aim, scan);
  return scan;
}

double AnalysisState::time_to_next_change(double aim) const {
  double first = std::numeric_limits<double>::infinity();
  for (const std::size_t b : blocks_with_regimes_) first = std::min(first, elements_[b]->next_fall(aim));
  return first;
}

void AnalysisState::change_regimes(std::vector<RegimeChange>& changes) {
  const std::size_t before = changes.size();
  for (const std::size_t b : blocks_with_regimes_) elements_[b]->change(b, changes);
  if (changes.size() == before) return;
  for (std::size_t i = before; i < changes.size(); ++i) changes[i].time = motion_.time;
  trial_ = motion_;
  evaluate();
}

double AnalysisState::shortest_contact() const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const std::size_t b : blocks_with_contacts_) shortest = std::min(shortest, elements_[b]->shortest_contact());
  return shortest;
}

}  // namespace moat
