// Nodes, elements and their state.
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <typeindex>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "base/copyable_pointer.hpp"
#include "base/vector.hpp"
#include "model/building.hpp"
#include "model/couplings.hpp"
#include "model/diaphragm.hpp"
#include "model/element_block.hpp"
#include "model/node.hpp"

namespace moat {

class GroundMotion;

/// The motion of all degrees of freedom at one instant, relative to the ground. Every vector has one entry more than
/// there are degrees of freedom: the last belongs to the ground and stays zero.
struct MotionState {
  double time = 0.0;    ///< s
  Vector displacement;  ///< m
  Vector velocity;      ///< m/s
  Vector acceleration;  ///< m/s^2
  Vector jerk;          ///< m/s^3, rate of the absolute acceleration: jumps with force rates, not with the ground
  /// Under which it came to this instant; null before the first analysis.
  std::shared_ptr<const GroundMotion> ground_motion{};
};

/// How the ground moves every degree of freedom: the shares of its two components. On a line all are 1 and 0.
struct GroundShares {
  /// One share per degree of freedom.
  const double *x, *y;

  /// The component of a vector of the ground, an acceleration for example, along degree of freedom i.
  [[nodiscard]] double of(PlanVector vector, int i) const { return x[i] * vector.x + y[i] * vector.y; }
};

/// A structure: nodes joined by elements, and all state of both.
///
/// Nodes and elements are added with the free functions add(model, ...). An analysis then moves the
/// model: it fills trial(), calls evaluate(), reads forces and tangents, and either commit()s the
/// trial state or overwrites it. A copy is complete and independent.
class Model {
 public:
  // All of these are defaults; compiled in the library, they cost no time in scripts.
  Model();
  Model(const Model& other);                 ///< A complete, independent copy.
  Model(Model&& other) noexcept;             ///< All of it.
  Model& operator=(const Model& other);      ///< As the copy.
  Model& operator=(Model&& other) noexcept;  ///< All of it.
  ~Model();

  /// Throws InputError for a mass that is not positive, a name that exists, a direction that has not length 1, and in a
  /// model with diaphragms for a node without direction.
  NodeId add_node(Node node);
  /// Throws InputError for a bad parameter, a name that exists, and in a model with nodes on a line.
  DiaphragmId add_diaphragm(const Diaphragm& diaphragm);
  [[nodiscard]] const std::vector<PlacedDiaphragm>& diaphragms() const { return diaphragms_; }  ///< All, as added.
  /// Throws InputError for one that is not of this model.
  [[nodiscard]] const PlacedDiaphragm& diaphragm(DiaphragmId id) const;
  /// The diaphragm to which a degree of freedom belongs; null for other nodes and the ground.
  [[nodiscard]] const PlacedDiaphragm* diaphragm_of(NodeId node) const;
  /// The nodes that move as one body with this one: the three of a diaphragm, or the node alone. Empty for the ground.
  [[nodiscard]] std::span<const NodeId> body_of(NodeId node) const;
  /// Whether it has diaphragms: it moves in plan, not on a line.
  [[nodiscard]] bool is_plan() const { return !diaphragms_.empty(); }
  [[nodiscard]] int node_count() const { return static_cast<int>(nodes_.size()); }  ///< Without the ground.
  [[nodiscard]] const Node& node(NodeId id) const;                        ///< One of the model; not the ground.
  [[nodiscard]] const std::deque<Node>& nodes() const { return nodes_; }  ///< In the order of their numbers.
  /// The node's name; "ground" for the ground.
  [[nodiscard]] std::string_view node_name(NodeId id) const;
  /// The name of the diaphragm to which a node belongs; its own name for other nodes.
  [[nodiscard]] std::string_view body_name(NodeId id) const;
  [[nodiscard]] bool has_element(const std::string& name) const {
    return element_names_.contains(name);
  }  ///< Whether the name is taken.
  /// Throws InputError unless id is the ground or a node of this model; the object of `check` and the field are named.
  void require_node(NodeId id, const Check& check, std::string_view field) const;
  /// Whether a node or a diaphragm has the name.
  [[nodiscard]] bool has_node(const std::string& name) const { return node_names_.contains(name); }
  /// Throws InputError if the name is empty or taken by another element.
  void register_element(std::string_view kind, const std::string& name);

  /// The block that holds elements of type Block; the first call makes it.
  template <class Block>
  Block& block();

  /// Throws InputError for a building without nodes, an unknown or repeated node, a node of another building, or a
  /// name that is taken.
  void add_building(Building building);
  [[nodiscard]] const std::vector<Building>& buildings() const { return buildings_; }  ///< As added.
  /// All elements.
  [[nodiscard]] const std::vector<CopyablePointer<ElementBlock>>& blocks() const { return blocks_; }

  /// Gives degrees of freedom their numbers and the matrix its pattern. Called by analyses; cheap when
  /// nothing was added since. Throws InputError for a model without nodes.
  void prepare();
  /// Whether nothing was added since prepare().
  [[nodiscard]] bool prepared() const { return prepared_; }

  [[nodiscard]] int degrees_of_freedom() const { return node_count(); }  ///< One per node, three per diaphragm.
  /// The diagonal of the mass matrix, kg.
  [[nodiscard]] const Vector& masses() const { return masses_; }
  /// The model must be prepared.
  [[nodiscard]] GroundShares ground_shares() const { return {ground_share_x_.data(), ground_share_y_.data()}; }
  /// A zero matrix with the entries of this model, which must be prepared.
  [[nodiscard]] SparseMatrix zero_matrix() const { return 0.0 * constant_stiffness_; }

  /// Committed motion of a node relative to the ground: m, m/s, m/s^2, m/s^3. Zero for the ground. The model must be
  /// prepared: an analysis of it exists, or prepare() was called. Throws InputError where it is not, and for a node
  /// that is not of this model.
  [[nodiscard]] double displacement(NodeId node) const { return state_.displacement[entry(node)]; }
  [[nodiscard]] double velocity(NodeId node) const { return state_.velocity[entry(node)]; }          ///< m/s, relative.
  [[nodiscard]] double acceleration(NodeId node) const { return state_.acceleration[entry(node)]; }  ///< m/s^2.
  /// rad, rad/s, counter-clockwise, of a diaphragm.
  [[nodiscard]] double rotation(DiaphragmId id) const { return displacement(id.r) / diaphragm(id).gyration; }
  /// rad/s
  [[nodiscard]] double angular_velocity(DiaphragmId id) const { return velocity(id.r) / diaphragm(id).gyration; }
  /// kg; the model must be prepared. Not for the ground.
  [[nodiscard]] double mass(NodeId node) const { return masses_[entry(node, masses_.size() - 1)]; }
  /// Rate of the node's absolute acceleration.
  [[nodiscard]] double jerk(NodeId node) const { return state_.jerk[entry(node)]; }

  /// The committed state.
  [[nodiscard]] const MotionState& state() const { return state_; }
  /// States committed from now on come about under this motion of the ground.
  void begin_motion(std::shared_ptr<const GroundMotion> motion) { state_.ground_motion = std::move(motion); }
  /// The state that evaluate() uses; analyses fill it.
  [[nodiscard]] MotionState& trial() { return trial_; }
  [[nodiscard]] const MotionState& trial() const { return trial_; }  ///< To read.

  /// Computes all elements and internal_forces() at the trial state.
  void evaluate();
  /// After evaluate(): the rates of all forces at the trial state, from both tangents and the trial accelerations, and
  /// from them the trial jerk, -M^-1 df/dt.
  void evaluate_rates();
  /// After a correction of the trial velocities: the results of elements with constant tangents at these velocities.
  /// Forces on nodes stay those of evaluate().
  void evaluate_linear_elements();
  /// Computes only the elements that can change their regime, with the rates of their forces: enough for
  /// scan_regimes() and change_regimes_inside(). evaluate() must follow before a commit().
  void evaluate_regimes();
  /// The linear system of the current regimes: df/du and df/dv, and the forces at zero displacement and velocity, as
  /// internal_forces() has them. evaluate() must follow before a commit().
  void linearise(SparseMatrix& stiffness, SparseMatrix& damping, Vector& forces);
  /// Internal forces of the last evaluate(). The last entry is the sum of the forces on the ground: the reactions.
  [[nodiscard]] const Vector& internal_forces() const { return internal_forces_; }
  /// Internal forces at the committed state, after the last change of regime; the last entry as above.
  [[nodiscard]] const Vector& committed_forces() const { return committed_forces_; }
  /// matrix := acceleration_weight M + velocity_weight df/dv + displacement_weight df/du.
  void assemble_tangent(double acceleration_weight, double velocity_weight, double displacement_weight,
                        SparseMatrix& matrix) const;
  /// A number that stays the same as long as df/du and df/dv do, from one evaluate() to the next.
  [[nodiscard]] long tangent_version() const { return tangent_version_; }
  /// The corners of forces inside the trial step that are not located; `lost` := the forces that nodes lose where paths
  /// turn, N (ElementBlock::find_corners).
  UnlocatedCorners find_corners(Vector& lost) const;
  /// The stiffness of a linear analysis, in which gaps are open.
  [[nodiscard]] SparseMatrix linear_stiffness(StiffnessStage stage) const;
  /// The trial state of nodes and elements becomes the committed one; energy accounts grow by the step between them,
  /// whose work is formed by `rule`. The contents of trial() are unspecified afterwards: the next step fills it.
  void commit(WorkRule rule = WorkRule::mean_force);
  /// Drops the trial state: results of all elements are those of the committed one again. Does nothing where something
  /// was added since prepare().
  void return_to_committed_state();
  /// Starts the energy accounts of all elements at the committed state; they are kept from then on.
  void start_energy_accounts();
  [[nodiscard]] bool keeps_energy_accounts() const { return keeps_energy_accounts_; }  ///< Once started.
  /// Looks for changes of regime between the committed and the trial state, `step` seconds apart;
  /// `aim` <= 0 m is the margin at which a located step should end.
  [[nodiscard]] RegimeScan scan_regimes(double step, double aim) const;
  /// The time, s, from the trial state to the next change of regime, after evaluate_rates() or evaluate_regimes()
  /// (Regimes::next_fall).
  [[nodiscard]] double time_to_next_change(double aim) const;
  /// Changes the regime of every element that is beyond its margin, then evaluates again at the committed state.
  void change_regimes(std::vector<RegimeChange>& changes);
  /// Changes the regime of elements that cross their margin inside the trial step, from there on
  /// (Regimes::change_inside); the step must then be solved again. False if one of them cannot be crossed:
  /// others may be changed by then, until undo_changes_inside().
  bool change_regimes_inside(double step, double aim, std::vector<RegimeChange>& changes);
  /// Takes back all changes inside the step being tried.
  void undo_changes_inside();
  /// The part that these rules leave out of the forces of elements that change inside the trial step, `step` s long, or
  /// changed inside the last ones (Regimes::add_missed_impulses). Returns whether there are such elements.
  bool find_missed_impulses(double step, const ImpulseRules& rules, MissedImpulses& missed);
  /// Number of gaps that are closed.
  [[nodiscard]] int contacts_going_on() const;
  /// Duration of the shortest contact in progress, s; infinite if there is none.
  [[nodiscard]] double shortest_contact() const;

 private:
  // The block of a type; `make` makes it if there is none.
  ElementBlock& block_of(std::type_index type, std::unique_ptr<ElementBlock> (*make)());
  NodeId append_node(Node node);
  // Returns the entry of a node in vectors of the committed state, whose last entry is that of the ground.
  [[nodiscard]] Eigen::Index entry(NodeId node) const {
    const Eigen::Index of_ground = state_.displacement.size() - 1;
    return node == ground && of_ground >= 0 ? of_ground : entry(node, of_ground - 1);
  }
  // Returns the entry of a node in a vector with entries up to `last`; throws for a node that has none.
  [[nodiscard]] Eigen::Index entry(NodeId node, Eigen::Index last) const {
    if (node.index < 0 || node.index > last) refuse_entry(node);
    return node.index;
  }
  [[noreturn]] void refuse_entry(NodeId node) const;

  std::deque<Node> nodes_;
  std::vector<NodeId> ids_;  // 0, 1, 2, ...
  std::vector<PlacedDiaphragm> diaphragms_;
  std::vector<int> diaphragm_of_node_;  // by node; -1 for none. Empty on a line
  std::unordered_set<std::string> node_names_, element_names_, building_names_;
  std::vector<CopyablePointer<ElementBlock>> blocks_;
  std::vector<std::type_index> block_types_;  // of blocks_
  std::vector<Building> buildings_;
  std::vector<bool> in_building_;  // by node

  bool prepared_ = false;
  Vector masses_;
  Vector ground_share_x_, ground_share_y_;
  std::vector<int> diagonal_slots_;
  SparseMatrix constant_stiffness_, constant_damping_;  // of elements with constant tangents
  MotionState state_, trial_;
  Vector internal_forces_, committed_forces_;
  long tangent_version_ = 0;
  std::vector<std::size_t> changing_blocks_, constant_blocks_;  // those without and with constant tangents
  std::vector<std::size_t> blocks_with_regimes_;
  std::vector<std::size_t> blocks_with_contacts_;
  bool keeps_energy_accounts_ = false;
};

template <class Block>
Block& Model::block() {
  const auto make = [] { return std::unique_ptr<ElementBlock>{new Block}; };
  return static_cast<Block&>(block_of(typeid(Block), make));
}

/// Adds a node.
inline NodeId add(Model& model, Node node) { return model.add_node(std::move(node)); }

/// Adds a diaphragm; throws as Model::add_diaphragm does.
inline DiaphragmId add(Model& model, const Diaphragm& diaphragm) { return model.add_diaphragm(diaphragm); }

/// Adds a building; throws as Model::add_building does.
inline void add(Model& model, Building building) { model.add_building(std::move(building)); }

}  // namespace moat
