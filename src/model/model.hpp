// Nodes, elements and their state.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <typeindex>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"
#include "model/element_block.hpp"
#include "model/node.hpp"
#include "model/taken_names.hpp"

namespace moat {

/// Where all degrees of freedom are at one instant, relative to the ground. Every vector has one
/// entry more than there are degrees of freedom: the last belongs to the ground and stays zero.
struct MotionState {
  double time = 0.0;    ///< s
  Vector displacement;  ///< m
  Vector velocity;      ///< m/s
  Vector acceleration;  ///< m/s^2
  Vector jerk;          ///< m/s^3, rate of the absolute acceleration: it jumps where forces bend, not with the ground
};

/// Reports the shear that the outside exerts on a set of nodes, from their inertia: the sum of mass
/// times absolute acceleration is the force of isolators and impacts together (`total_base_shear`);
/// the sum of the maxima of its terms is the design value that many papers quote
/// (`sum_of_floor_inertia_maxima`).
struct BaseShear {
  /// Where the two quantities are listed.
  std::string where = "base";
  std::vector<NodeId> nodes;
};

/// A structure: nodes joined by elements, and all state of both.
///
/// Nodes and elements are added with the free functions add(model, ...). An analysis then moves the
/// model: it fills trial(), calls evaluate(), reads forces and tangents, and either commit()s the
/// trial state or overwrites it. A copy is complete and independent.
class Model {
 public:
  Model() = default;
  Model(const Model& other);
  Model& operator=(const Model& other);
  Model(Model&&) noexcept = default;
  Model& operator=(Model&&) noexcept = default;
  ~Model() = default;

  /// Throws InputError for a mass that is not positive or a name that exists.
  NodeId add_node(Node node);
  [[nodiscard]] int node_count() const { return static_cast<int>(nodes_.size()); }
  [[nodiscard]] const Node& node(NodeId id) const;
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// The node's name; "ground" for the ground.
  [[nodiscard]] std::string_view node_name(NodeId id) const;
  /// m1 m2 / (m1 + m2) of two nodes, kg; the ground's mass is infinite.
  [[nodiscard]] double effective_mass(NodeId a, NodeId b) const;
  [[nodiscard]] bool has_element(const std::string& name) const;
  /// Throws InputError unless id is the ground or a node of this model; `object` and `field` are named.
  void require_node(NodeId id, std::string_view object, std::string_view field) const;
  [[nodiscard]] bool has_node(const std::string& name) const;
  /// Throws InputError if the name is empty or taken by another element.
  void register_element(std::string_view kind, const std::string& name);

  /// The block that holds elements of type Block, made when first asked for.
  template <class Block>
  Block& block();

  void add_base_shear(BaseShear shear);
  [[nodiscard]] const std::vector<BaseShear>& base_shears() const { return base_shears_; }
  [[nodiscard]] const std::vector<std::unique_ptr<ElementBlock>>& blocks() const { return blocks_; }

  /// Gives degrees of freedom their numbers and the matrix its pattern. Called by analyses; cheap when
  /// nothing was added since. Throws InputError for a model without nodes.
  void prepare();
  /// Whether nothing was added since prepare().
  [[nodiscard]] bool prepared() const { return prepared_; }

  [[nodiscard]] int degrees_of_freedom() const { return node_count(); }
  /// The diagonal of the mass matrix, kg.
  [[nodiscard]] const Vector& masses() const { return masses_; }
  /// A zero matrix with the pattern of this model.
  [[nodiscard]] const SparseMatrix& pattern() const { return pattern_; }

  /// The committed state.
  [[nodiscard]] const MotionState& state() const { return state_; }
  /// The state that evaluate() looks at, for analyses to fill.
  [[nodiscard]] MotionState& trial() { return trial_; }
  [[nodiscard]] const MotionState& trial() const { return trial_; }

  /// Computes all elements at the trial state.
  void evaluate();
  /// After evaluate(): the rates of all forces at the trial state, from both tangents and the trial accelerations, and
  /// from them the trial jerk, -M^-1 df/dt.
  void evaluate_rates();
  /// Computes only the elements that can change their regime; forces and deformations of the others stay those of the
  /// last evaluate(). For analyses that know the motion of the nodes without the forces and have no observer of them.
  void evaluate_regimes();
  /// Computes all elements at the committed state, where evaluate_regimes() left some out.
  void refresh();
  /// Internal forces of the last evaluate(); one entry more than degrees of freedom, which has no meaning.
  [[nodiscard]] const Vector& internal_forces() const { return internal_forces_; }
  /// force := internal_forces().
  void internal_forces(Vector& force) const { force = internal_forces_; }
  /// matrix := acceleration_weight M + velocity_weight df/dv + displacement_weight df/du.
  void assemble_tangent(double acceleration_weight, double velocity_weight, double displacement_weight,
                        SparseMatrix& matrix) const;
  /// A number that stays the same as long as df/du and df/dv do, from one evaluate() to the next.
  [[nodiscard]] long tangent_version() const { return tangent_version_; }
  /// Whether a force has a corner inside the trial step that is not located (ElementBlock::has_corner).
  [[nodiscard]] bool has_corner() const;
  /// matrix := stiffness of a linear analysis.
  void assemble_linear_stiffness(StiffnessStage stage, SparseMatrix& matrix) const;
  /// The trial state of nodes and elements becomes the committed one; energy accounts grow by the step between them,
  /// whose work is formed by `rule`. What trial() holds afterwards is not specified: the next step fills it.
  void commit(WorkRule rule = WorkRule::mean_force);
  /// Starts the energy accounts of all elements at the committed state; they are kept from then on.
  void start_energy_account();
  [[nodiscard]] bool keeps_energy_accounts() const { return keeps_energy_accounts_; }
  /// Evaluates and assembles on up to `threads` >= 1 threads from now on; the numbers stay the same to the last bit.
  /// The model must be prepared.
  void use_threads(int threads);
  /// Looks for changes of regime between the committed and the trial state, `step` seconds apart;
  /// `aim` <= 0 is where a located step should end (RegimeScan).
  [[nodiscard]] RegimeScan scan_regimes(double step, double aim) const;
  /// Changes the regime of every element that is beyond its margin, then evaluates anew at the committed state.
  void change_regimes(std::vector<RegimeChange>& changes);
  /// Changes the regime of elements that cross their margin inside the trial step, from there on
  /// (ElementBlock::change_regimes_inside); the step must then be solved again. False if one of them cannot be crossed:
  /// others may be changed by then, until undo_changes_inside().
  bool change_regimes_inside(double step, double aim, std::vector<RegimeChange>& changes);
  /// Takes back all changes inside the step being tried.
  void undo_changes_inside();
  /// After commit(): gaps that opened inside the step; their forces are zero already.
  void open_gaps(std::vector<RegimeChange>& changes);
  /// Duration of the shortest contact going on, s; infinite if there is none.
  [[nodiscard]] double shortest_contact() const;

 private:
  std::vector<Node> nodes_;
  TakenNames node_names_, element_names_;
  std::vector<std::unique_ptr<ElementBlock>> blocks_;
  std::unordered_map<std::type_index, std::size_t> block_of_type_;
  std::unordered_set<std::string> base_shear_names_;
  std::vector<BaseShear> base_shears_;

  bool prepared_ = false;
  Vector masses_;
  std::vector<int> diagonal_slots_;
  SparseMatrix pattern_;
  // Tangents of the blocks for which they never change, as values of the pattern.
  std::vector<double> constant_stiffness_, constant_damping_;
  MotionState state_, trial_;
  Vector internal_forces_, force_rates_;
  long tangent_version_ = 0;
  std::vector<std::size_t> changing_blocks_;  // those without constant tangent
  std::vector<std::size_t> blocks_with_regimes_;
  bool only_regimes_evaluated_ = false;
  bool keeps_energy_accounts_ = false;
  int threads_ = 1;
};

template <class Block>
Block& Model::block() {
  prepared_ = false;
  const auto [found, inserted] = block_of_type_.try_emplace(std::type_index{typeid(Block)}, blocks_.size());
  if (inserted) blocks_.push_back(std::make_unique<Block>());
  return static_cast<Block&>(*blocks_[found->second]);
}

/// Adds a node.
inline NodeId add(Model& model, Node node) { return model.add_node(std::move(node)); }

/// Adds a report of base shear. Throws InputError for an empty, unknown or repeated node, or a name that is taken.
inline void add(Model& model, BaseShear shear) { model.add_base_shear(std::move(shear)); }

}  // namespace moat
