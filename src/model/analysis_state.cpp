#include "model/analysis_state.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/text/number_format.hpp"

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
  for (const Building& building : model.buildings()) {
    if (!building.axial_forces) continue;
    weights_.emplace_back(model, building, elements_);
    weights_.back().add_rows(coupling_.rows);
    feels_accelerations_ = feels_accelerations_ || weights_.back().acts_on_laws();
  }
  for (std::size_t b = 0; b < elements_.size(); ++b)
    (weights_.empty() || elements_[b]->axial_actions().compressions.empty() ? other_blocks_ : blocks_under_weight_)
        .push_back(b);
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
  bool changed = false;
  for (const std::size_t b : other_blocks_) changed |= evaluate(b);
  if (!weights_.empty()) {
    other_forces_ = internal_forces_;
    changed |= evaluate_under_weight();
  }
  if (changed) ++tangent_version_;
}

bool AnalysisState::evaluate_under_weight() {
  for (WeightOnBearings& weight : weights_) weight.press(trial_, ground_, elements_);
  internal_forces_ = other_forces_;
  bool changed = false;
  for (const std::size_t b : blocks_under_weight_) changed |= evaluate(b);
  return changed;
}

std::vector<ElementId> AnalysisState::elements_without_axial_force() const {
  std::vector<ElementId> list;
  for (std::size_t b = 0; b < elements_.size(); ++b) {
    const AxialActions axial = elements_[b]->axial_actions();
    for (std::size_t e = 0; e < axial.compressions.size(); ++e)
      if (axial.compressions[e] == 0.0 && std::ranges::none_of(weights_, [&](const WeightOnBearings& weight) {
            return std::ranges::find(weight.bearings(), ElementId{b, e}, &WeightOnBearings::Bearing::element) !=
                   weight.bearings().end();
          }))
        list.push_back({b, e});
  }
  return list;
}

void AnalysisState::find(WeightCoupling& coupling) const {
  if (coupling.rows.empty()) coupling.rows = coupling_.rows;
  coupling.columns.resize(coupling.rows.size());
  std::size_t column = 0;
  for (const WeightOnBearings& weight : weights_)
    column = weight.fill_columns(elements_, internal_forces_.size(), coupling.columns, column);
}

bool AnalysisState::turn_ground(double vertical_rate) {
  if (vertical_rate == vertical_ground_rate_ || std::ranges::none_of(weights_, &WeightOnBearings::moves_with_ground))
    return false;
  vertical_ground_rate_ = vertical_rate;
  return_to_committed_state();
  commit();
  return true;
}

// M j + f' = 0, where f' grows with the rates of the axial forces, and these with j.
void AnalysisState::evaluate_rates() {
  const int count = model_->degrees_of_freedom();
  const auto solve = [&](Vector& values) { model_->mass_matrix().solve(values.data()); };
  const auto add_rates = [&](const std::vector<std::size_t>& blocks, Vector& rates) {
    for (const std::size_t b : blocks) elements_[b]->evaluate_rates(trial_.acceleration.data(), rates.data());
  };
  const auto turn_into_jerk = [&](Vector& rates) {
    solve(rates);
    rates.head(count) *= -1.0;
    rates[count] = 0.0;
  };
  if (weights_.empty()) {
    trial_.jerk.setZero(count + 1);
    add_rates(other_blocks_, trial_.jerk);
    turn_into_jerk(trial_.jerk);
    return;
  }
  const auto find_jerk = [&](const Vector& others, Vector& jerk) {
    jerk = others;
    add_rates(blocks_under_weight_, jerk);
    turn_into_jerk(jerk);
  };
  const auto find_axial_rates = [&] {
    for (WeightOnBearings& weight : weights_) weight.find_rates(trial_, vertical_ground_rate_, elements_);
  };
  rates_of_others_.setZero(count + 1);
  add_rates(other_blocks_, rates_of_others_);
  find_jerk(rates_of_others_, trial_.jerk);
  find_axial_rates();
  if (!feels_accelerations_) return;
  find(coupling_);
  coupling_.prepare(count, solve);
  Vector change;
  find_jerk(rates_of_others_, change);
  change -= trial_.jerk;
  coupling_.correct(change);
  trial_.jerk += change;
  find_axial_rates();
  find_jerk(rates_of_others_, trial_.jerk);
}

void AnalysisState::evaluate_linear_elements() {
  const double step = trial_.time - motion_.time;
  for (const std::size_t b : constant_blocks_) {
    elements_[b]->evaluate(step, trial_.displacement.data(), trial_.velocity.data(), nullptr);
    elements_[b]->evaluate_rates(trial_.acceleration.data(), nullptr);
  }
}

void AnalysisState::balance_forces(GroundVector ground_acceleration) {
  const int count = model_->degrees_of_freedom();
  const GroundColumns influence = model_->ground_influence();
  trial_.acceleration.head(count) = internal_forces_.head(count);
  model_->mass_matrix().solve(trial_.acceleration.data());
  for (int i = 0; i < count; ++i)
    trial_.acceleration[i] = -trial_.acceleration[i] - influence.times(ground_acceleration, i);
}

void AnalysisState::balance(GroundVector ground_acceleration) {
  ground_ = ground_acceleration;
  if (!feels_accelerations_) {
    balance_forces(ground_acceleration);
    if (!weights_.empty()) evaluate_under_weight();
    return;
  }
  constexpr int most_iterations = 50;
  constexpr double round_off = 1e-14, settled = 1e-9;
  double missing = 0.0;
  const auto solve = [&](Vector& values) { model_->mass_matrix().solve(values.data()); };
  for (int count = 0; count < most_iterations; ++count) {
    const Vector before = trial_.acceleration;
    balance_forces(ground_acceleration);
    Vector change = trial_.acceleration - before;
    find(coupling_);
    coupling_.prepare(model_->degrees_of_freedom(), solve);
    coupling_.correct(change);
    trial_.acceleration = before + change;
    evaluate_under_weight();
    const double size = trial_.acceleration.lpNorm<Eigen::Infinity>(), off = change.lpNorm<Eigen::Infinity>();
    // A law that has no answer gives numbers that are not finite.
    const bool finite = trial_.acceleration.allFinite() && change.allFinite();
    if (finite && off <= round_off * size) return;
    missing = finite ? off / size : std::numeric_limits<double>::quiet_NaN();
    if (!finite) break;
  }
  if (!(missing <= settled))
    throw ConvergenceError{
        "The accelerations and the axial forces of the bearings do not settle at t = " + to_text(trial_.time) +
            " s. Check the friction coefficients, heights and positions of "
            "bearings.",
        motion_.time, trial_.time - motion_.time, missing, "bearings"};
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
  for (WeightOnBearings& weight : weights_) weight.accept(step, trial_.time);
  committed_ground_ = ground_;
  std::swap(motion_, trial_);
  committed_forces_.swap(internal_forces_);
  for (const auto& elements : elements_) elements->commit(step, rule);
  for (WeightOnBearings& weight : weights_) weight.note_instability(step, motion_.time, elements_);
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
  ground_ = committed_ground_;
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
