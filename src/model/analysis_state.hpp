// The state of a model in one analysis.
#pragma once

#include <memory>
#include <vector>

#include "base/copyable_pointer.hpp"
#include "model/model.hpp"
#include "model/weight/weight_on_bearings.hpp"

namespace moat {

class GroundMotion;

/// The motion of a model, the states and energies of its elements, and its forces and matrices. The model itself never
/// changes. A new state stands at time zero, with initial displacements and velocities and without any history; a copy
/// is complete and independent.
///
/// There are a committed state and a trial state. An analysis fills trial(), calls evaluate(), reads forces and
/// tangents, and either commit()s the trial state or overwrites it.
///
///     AnalysisState state = analysis.state();      // later: Transient{model, next_motion, state}
class AnalysisState {
 public:
  /// The model must outlive the state, stay where it is, and not be added to meanwhile. Throws InputError for a model
  /// without nodes.
  explicit AnalysisState(const Model& model);

  [[nodiscard]] const Model& model() const { return *model_; }  ///< The model that is analysed.
  /// Whether nothing was added to the model since this state was made.
  [[nodiscard]] bool fits_model() const { return additions_ == model_->additions(); }

  [[nodiscard]] double time() const { return motion_.time; }           ///< s
  [[nodiscard]] const MotionState& motion() const { return motion_; }  ///< The committed motion.
  /// Committed motion of a node relative to the ground: m, m/s, m/s^2. Zero for the ground. Throws InputError for a
  /// node that is not of this model.
  [[nodiscard]] double displacement(NodeId node) const { return value(motion_.displacement, node); }
  [[nodiscard]] double velocity(NodeId node) const { return value(motion_.velocity, node); }  ///< m/s, relative.
  [[nodiscard]] double acceleration(NodeId node) const { return value(motion_.acceleration, node); }  ///< m/s^2.
  /// Rate of the node's absolute acceleration, m/s^3.
  [[nodiscard]] double jerk(NodeId node) const { return value(motion_.jerk, node); }
  /// rad, counter-clockwise, of a diaphragm.
  [[nodiscard]] double rotation(DiaphragmId id) const { return displacement(id.r) / model_->diaphragm(id).gyration; }
  /// rad/s
  [[nodiscard]] double angular_velocity(DiaphragmId id) const {
    return velocity(id.r) / model_->diaphragm(id).gyration;
  }
  /// The states of the elements of a block, by its index in Model::blocks().
  [[nodiscard]] const ElementStates& elements(std::size_t block) const { return *elements_[block]; }
  /// Returns them to set axial forces.
  [[nodiscard]] ElementStates& elements(std::size_t block) { return *elements_[block]; }

  /// The motion of the ground under which it came to this instant; null before the first analysis.
  [[nodiscard]] const GroundMotion* ground_motion() const { return ground_motion_.get(); }
  /// States committed from now on come about under this motion of the ground.
  void begin_motion(std::shared_ptr<const GroundMotion> motion) { ground_motion_ = std::move(motion); }
  /// The axial forces of the bearings of every building with AxialForces.
  [[nodiscard]] std::span<const WeightOnBearings> weights() const { return weights_; }
  [[nodiscard]] std::span<WeightOnBearings> weights() { return weights_; }  ///< To move them in their vertical modes.
  /// Elements whose law takes an axial force that no building gives, and that is 0.
  [[nodiscard]] std::vector<ElementId> elements_without_axial_force() const;
  /// Whether forces of elements follow axial forces, and so depend on accelerations.
  [[nodiscard]] bool feels_accelerations() const { return feels_accelerations_; }
  /// After evaluate(), where it feels accelerations: fills the part of the tangent that they give.
  void find(WeightCoupling& coupling) const;
  /// The trial state has this acceleration of the ground, m/s^2. Only states with weights() need it.
  void move_ground(GroundVector acceleration) { ground_ = acceleration; }
  /// The rate of the ground's vertical acceleration, m/s^3, from the committed instant on. Where it jumps and axial
  /// forces follow it: finds the rates of the committed state again, and returns true.
  bool turn_ground(double vertical_rate);
  /// Returns the rate that turn_ground() set, m/s^3.
  [[nodiscard]] double vertical_ground_rate() const { return vertical_ground_rate_; }
  [[nodiscard]] double kinetic_energy() const;  ///< J, of the motion relative to the ground.
  /// Starts the energy accounts of all elements at the committed state; they are kept from then on.
  void start_energy_accounts();
  /// Whether start_energy_accounts() was called.
  [[nodiscard]] bool keeps_energy_accounts() const { return keeps_energy_accounts_; }

  /// The state that evaluate() uses; analyses fill it.
  [[nodiscard]] MotionState& trial() { return trial_; }
  [[nodiscard]] const MotionState& trial() const { return trial_; }  ///< The trial motion, to read.
  /// Computes all elements and internal_forces() at the trial state.
  void evaluate();
  /// After evaluate(): the rates of all forces at the trial state, from both tangents and the trial accelerations, and
  /// from them the trial jerk, -M^-1 df/dt.
  void evaluate_rates();
  /// After a correction of the trial velocities: the results of elements with constant tangents at these velocities.
  /// Forces on nodes stay those of evaluate().
  void evaluate_linear_elements();
  /// After evaluate(): the trial accelerations that balance the internal forces, -M^-1 f - iota a_g, under this
  /// acceleration of the ground, m/s^2.
  void balance(GroundVector ground_acceleration);
  /// Computes accelerations and jerks of the committed state from its forces, for the start and after events.
  void balance_committed_state(GroundVector ground_acceleration);
  /// The linear system of the current regimes: df/du and df/dv, and the forces at zero displacement and velocity, as
  /// internal_forces() has them. evaluate() must follow before a commit().
  void linearise(SparseMatrix& stiffness, SparseMatrix& damping, Vector& forces);
  /// Internal forces of the last evaluate(). The last entry is of the ground.
  [[nodiscard]] const Vector& internal_forces() const { return internal_forces_; }
  /// Internal forces at the committed state, after the last change of regime.
  [[nodiscard]] const Vector& committed_forces() const { return committed_forces_; }
  /// M iota: the forces, N, on every degree of freedom for an acceleration of 1 m/s^2 of each component of the ground.
  [[nodiscard]] GroundColumns ground_inertia() const {
    return {ground_inertia_.col(0).data(), ground_inertia_.col(1).data(), ground_inertia_.col(2).data()};
  }
  /// A zero matrix with the entries of the model.
  [[nodiscard]] SparseMatrix zero_matrix() const { return 0.0 * constant_stiffness_; }
  /// matrix := acceleration_weight M + velocity_weight df/dv + displacement_weight df/du.
  void assemble_tangent(double acceleration_weight, double velocity_weight, double displacement_weight,
                        SparseMatrix& matrix) const;
  /// A number that stays the same as long as df/du and df/dv do, from one evaluate() to the next.
  [[nodiscard]] long tangent_version() const { return tangent_version_; }
  /// The corners of forces inside the trial step that are not located; `lost` := the forces that nodes lose where paths
  /// turn, N (ElementStates::find_corners).
  UnlocatedCorners find_corners(Vector& lost) const;
  /// The trial state of nodes and elements becomes the committed one; energy accounts grow by the step between them,
  /// whose work is formed by `rule`. The contents of trial() are unspecified afterwards: the next step fills it.
  void commit(WorkRule rule = WorkRule::mean_force);
  /// Drops the trial state: results of all elements are those of the committed one again.
  void return_to_committed_state();

  /// Looks for changes of regime between the committed and the trial state, `step` seconds apart;
  /// `aim` <= 0 m is the margin at which a located step should end.
  [[nodiscard]] RegimeScan scan_regimes(double step, double aim) const;
  /// The time, s, from the trial state to the next change of regime, after evaluate_rates() (ElementStates::next_fall).
  [[nodiscard]] double time_to_next_change(double aim) const;
  /// Changes the regime of every element that is beyond its margin, then evaluates again at the committed state.
  void change_regimes(std::vector<RegimeChange>& changes);
  /// Duration of the shortest contact in progress, s; infinite if there is none.
  [[nodiscard]] double shortest_contact() const;

  /// Writes the state, or reads it back into one of the same model: all but the sums that evaluate() and balance() form
  /// before they use them.
  void archive(StateArchive& archive) {
    archive(motion_, trial_, internal_forces_, committed_forces_, ground_, committed_ground_, vertical_ground_rate_,
            tangent_version_, keeps_energy_accounts_);
    for (const auto& elements : elements_) elements->archive(archive);
    for (WeightOnBearings& weight : weights_) weight.archive(archive);
  }

 private:
  bool evaluate(std::size_t block) {
    return elements_[block]->evaluate(trial_.time - motion_.time, trial_.displacement.data(), trial_.velocity.data(),
                                      internal_forces_.data());
  }
  bool evaluate_under_weight();
  void balance_forces(GroundVector ground_acceleration);
  // Returns the value of a node in a vector of the motion.
  [[nodiscard]] double value(const Vector& values, NodeId node) const {
    const bool is_entry = node.index >= 0 && node.index < values.size() - 1;
    return is_entry ? values[node.index] : value_of_other(values, node);
  }
  // Returns the value of the ground, or of a follower.
  [[nodiscard]] double value_of_other(const Vector& values, NodeId node) const;

  const Model* model_;
  long additions_;
  MotionState motion_, trial_;
  std::shared_ptr<const GroundMotion> ground_motion_;
  std::vector<CopyablePointer<ElementStates>> elements_;  // by block
  // Indices of blocks without and with constant tangents, with regimes, and with contacts.
  std::vector<std::size_t> changing_blocks_, constant_blocks_, blocks_with_regimes_, blocks_with_contacts_;
  SparseMatrix constant_stiffness_, constant_damping_;  // of elements with constant tangents
  Eigen::Matrix<double, Eigen::Dynamic, 3> ground_inertia_;
  Vector internal_forces_, committed_forces_;
  // Where forces follow axial forces: the blocks with such laws are evaluated after all others.
  std::vector<WeightOnBearings> weights_;
  std::vector<std::size_t> blocks_under_weight_, other_blocks_;
  WeightCoupling coupling_;                // of accelerations and jerks
  Vector other_forces_, rates_of_others_;  // of other_blocks_
  GroundVector ground_{}, committed_ground_{};
  double vertical_ground_rate_ = 0.0;
  bool feels_accelerations_ = false;
  long tangent_version_ = 0;
  bool keeps_energy_accounts_ = false;
};

}  // namespace moat
