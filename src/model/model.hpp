// Bodies, elements and buildings, as they were added.
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
#include "model/body.hpp"
#include "model/building.hpp"
#include "model/diaphragm.hpp"
#include "model/element_block.hpp"
#include "model/mass_matrix.hpp"

namespace moat {

/// The motion of all degrees of freedom at one instant, relative to the ground. Every vector has one entry more than
/// there are degrees of freedom: the last belongs to the ground and stays zero.
struct MotionState {
  double time = 0.0;    ///< s
  Vector displacement;  ///< m
  Vector velocity;      ///< m/s
  Vector acceleration;  ///< m/s^2
  Vector jerk;          ///< m/s^3, rate of the absolute acceleration: jumps with force rates, not with the ground

  void archive(auto& archive) { archive(time, displacement, velocity, acceleration, jerk); }  ///< StateArchive.
};

/// A structure: bodies, elements and buildings, as the free functions add(model, ...) added them. Analyses do not
/// change it; each has an AnalysisState of its own (model/analysis_state.hpp), so that one model serves many motions
/// and threads. A copy is complete and independent.
class Model {
 public:
  // All of these are defaults; compiled in the library, they cost no time in scripts.
  Model();
  Model(const Model& other);                 ///< Makes a complete, independent copy.
  Model(Model&& other) noexcept;             ///< Takes the whole model.
  Model& operator=(const Model& other);      ///< Makes a complete, independent copy.
  Model& operator=(Model&& other) noexcept;  ///< Takes the whole model.
  ~Model();

  /// Throws InputError for a mass that is not positive, a name that exists, a direction that has not length 1, and in a
  /// model with diaphragms for a node without direction.
  NodeId add_node(const Node& node);
  /// Throws InputError for a bad parameter, a name that exists, and in a model with nodes on a line.
  DiaphragmId add_diaphragm(const Diaphragm& diaphragm);
  /// Returns its degrees of freedom. Throws InputError for a bad parameter and a name that exists.
  std::vector<NodeId> add_body(const GeneralisedBody& body);
  /// Adds a node that follows others; its mass, > 0 kg, is for results alone. Throws InputError as the other does, and
  /// for an unknown node or a weight that is not finite.
  NodeId add_follower(const Node& node, Follower motion);
  /// Adds a diaphragm that follows others.
  DiaphragmId add_follower(const Diaphragm& diaphragm, Follower motion);
  /// Adds a symmetric matrix, kg, to the mass matrix in the rows and columns of these degrees of freedom. Throws
  /// InputError for unknown or repeated ones, and where the mass matrix is not positive definite then.
  void add_mass(const std::vector<NodeId>& nodes, const Eigen::MatrixXd& mass);
  /// Throws InputError for a building without nodes, an unknown or repeated node, a node of another building, or a
  /// name that is taken.
  void add_building(Building building);
  /// Keeps a sentence about the input, which results repeat among their assumptions.
  void add_note(std::string note) { notes_.push_back(std::move(note)); }
  /// Throws InputError if the name is empty or taken by another element.
  void register_element(std::string_view kind, const std::string& name);
  /// The block that holds elements of type Block; the first call makes it.
  template <class Block>
  Block& block();

  [[nodiscard]] const std::deque<Body>& bodies() const { return bodies_; }  ///< In the order in which they were added.
  /// The body of a degree of freedom. Throws InputError for the ground and for one that is not of this model.
  [[nodiscard]] const Body& body(NodeId node) const;
  /// The nodes of the body of a node: one, or three of a diaphragm. Empty for the ground.
  [[nodiscard]] std::vector<NodeId> nodes_of_body(NodeId node) const;
  /// The degrees of freedom that move the body of a node: its own, or those that it follows. Empty for the ground.
  [[nodiscard]] std::vector<NodeId> body_of(NodeId node) const;
  /// The nodes whose accelerations jump with the force of an element, each once: the degrees of freedom of the bodies
  /// at its ends, those that masses couple with them, and their followers.
  [[nodiscard]] std::vector<NodeId> struck_by(const ElementInfo& element) const;
  /// The displacement of a node as a sum over degrees of freedom. Empty for the ground.
  [[nodiscard]] std::span<const MotionShare> shares(NodeId node) const;
  [[nodiscard]] const std::vector<PlacedDiaphragm>& diaphragms() const { return diaphragms_; }  ///< All, as added.
  /// Throws InputError for one that is not of this model.
  [[nodiscard]] const PlacedDiaphragm& diaphragm(DiaphragmId id) const;
  /// The diaphragm to which a degree of freedom belongs; null for other nodes and the ground.
  [[nodiscard]] const PlacedDiaphragm* diaphragm_of(NodeId node) const;
  /// Whether it has diaphragms: it moves in plan, not on a line.
  [[nodiscard]] bool is_plan() const { return !diaphragms_.empty(); }
  /// In the order in which they were added.
  [[nodiscard]] const std::vector<Building>& buildings() const { return buildings_; }
  /// In the order in which they were added.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// All elements.
  [[nodiscard]] const std::vector<CopyablePointer<ElementBlock>>& blocks() const { return blocks_; }

  /// The name of a degree of freedom, that of the node; "ground" for the ground.
  [[nodiscard]] std::string_view node_name(NodeId id) const;
  /// The name of the body to which a degree of freedom belongs; "ground" for the ground.
  [[nodiscard]] std::string_view body_name(NodeId id) const;
  /// Whether a body or a degree of freedom has the name.
  [[nodiscard]] bool has_node(const std::string& name) const { return body_names_.contains(name); }
  /// Throws InputError unless id is the ground or a node of this model; the object of `check` and the field are named.
  void require_node(NodeId id, const Check& check, std::string_view field) const;

  /// One per node, three per diaphragm, none of a follower.
  [[nodiscard]] int degrees_of_freedom() const { return static_cast<int>(names_.size()); }
  /// The number of degrees of freedom and of nodes that follow them.
  [[nodiscard]] int nodes() const { return degrees_of_freedom() + static_cast<int>(followers_.size()); }
  /// The place of a node, not the ground, among all of them: degrees of freedom first.
  [[nodiscard]] int place(NodeId node) const {
    return node.is_follower() ? degrees_of_freedom() + node.index - NodeId::first_follower : node.index;
  }
  /// The node at a place.
  [[nodiscard]] NodeId node(int place) const {
    const int beyond = place - degrees_of_freedom();
    return NodeId{beyond < 0 ? place : NodeId::first_follower + beyond};
  }
  [[nodiscard]] const MassMatrix& mass_matrix() const { return mass_; }  ///< kg
  /// The mass of a node as it was added, kg, without that of add_mass(). Throws InputError for one that is not of this
  /// model.
  [[nodiscard]] double mass(NodeId node) const;
  /// The acceleration of a node, m/s^2, under this one of the ground, m/s^2, where nothing deforms.
  [[nodiscard]] double moved_by_ground(NodeId node, GroundVector ground_acceleration) const;
  /// The displacement of every degree of freedom when the ground moves by 1 along each of its components and nothing
  /// deforms: iota. Valid until something is added.
  [[nodiscard]] GroundColumns ground_influence() const {
    return {influence_x_.data(), influence_y_.data(), influence_z_.data()};
  }
  /// Whether all degrees of freedom move along x with the ground, as on a line.
  [[nodiscard]] bool moves_along_x() const { return moves_along_x_; }
  /// Displacements and velocities at time zero.
  [[nodiscard]] MotionState initial_motion() const;
  /// A zero matrix with an entry for every pair of degrees of freedom that elements or masses couple.
  [[nodiscard]] SparseMatrix zero_matrix() const;
  /// The stiffness of a linear analysis, in which gaps are open.
  [[nodiscard]] SparseMatrix linear_stiffness(StiffnessStage stage) const;
  /// The number of calls that added something so far. An AnalysisState belongs to the model with the number it had
  /// then.
  [[nodiscard]] long additions() const { return additions_; }

 private:
  [[nodiscard]] bool is_known(NodeId node) const {
    return node.index >= 0 && place(node) < (node.is_follower() ? nodes() : degrees_of_freedom());
  }
  // The block of a type; `make` makes it if there is none.
  ElementBlock& block_of(std::type_index type, std::unique_ptr<ElementBlock> (*make)());
  void check_new_name(const Check& check, const std::string& name) const;
  // Appends a degree of freedom of the last body.
  NodeId append(std::string name, double mass, GroundVector influence, double displacement, double velocity);
  void begin_body(Body body);
  [[nodiscard]] Body checked(const Node& node) const;
  [[nodiscard]] PlacedDiaphragm checked(const Diaphragm& diaphragm) const;
  [[nodiscard]] Body body_of_diaphragm(const PlacedDiaphragm& placed, bool free, bool follows) const;
  void check_follower(const Check& check, const Follower& motion, std::size_t rows) const;
  NodeId append_follower(std::string name, double mass, const Follower& motion, std::size_t row);

  struct FollowingNode {
    std::string name;
    double mass;  // kg
    GroundVector influence;
    std::vector<MotionShare> shares;
    std::size_t body;
  };
  [[nodiscard]] const FollowingNode& follower(NodeId node) const {
    return followers_[static_cast<std::size_t>(node.index - NodeId::first_follower)];
  }

  std::deque<Body> bodies_;
  std::vector<PlacedDiaphragm> diaphragms_;
  std::vector<CopyablePointer<ElementBlock>> blocks_;
  std::vector<std::type_index> block_types_;  // of blocks_
  std::vector<Building> buildings_;
  std::vector<std::string> notes_;
  std::unordered_set<std::string> body_names_, element_names_, building_names_;
  // One entry per degree of freedom.
  std::deque<std::string> names_;
  std::vector<MotionShare> own_shares_;  // of every degree of freedom: itself
  std::vector<std::size_t> body_of_;
  std::vector<double> given_masses_, influence_x_, influence_y_, influence_z_, initial_displacement_, initial_velocity_;
  std::unordered_set<int> in_building_;  // indices of nodes
  MassMatrix mass_;
  std::deque<FollowingNode> followers_;
  bool moves_along_x_ = true;
  long additions_ = 0;
};

template <class Block>
Block& Model::block() {
  const auto make = [] { return std::unique_ptr<ElementBlock>{new Block}; };
  return static_cast<Block&>(block_of(typeid(Block), make));
}

/// Adds a node; throws as Model::add_node does.
inline NodeId add(Model& model, const Node& node) { return model.add_node(node); }

/// Adds a diaphragm; throws as Model::add_diaphragm does.
inline DiaphragmId add(Model& model, const Diaphragm& diaphragm) { return model.add_diaphragm(diaphragm); }

/// Adds a body in generalised coordinates; throws as Model::add_body does.
inline std::vector<NodeId> add(Model& model, const GeneralisedBody& body) { return model.add_body(body); }

/// Adds a node that follows others; throws as Model::add_follower does.
inline NodeId add(Model& model, const Node& node, Follower motion) {
  return model.add_follower(node, std::move(motion));
}

/// Adds a diaphragm that follows others; throws as Model::add_follower does.
inline DiaphragmId add(Model& model, const Diaphragm& diaphragm, Follower motion) {
  return model.add_follower(diaphragm, std::move(motion));
}

/// Adds a building; throws as Model::add_building does.
inline void add(Model& model, Building building) { model.add_building(std::move(building)); }

}  // namespace moat
