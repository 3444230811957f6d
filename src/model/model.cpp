#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "model/checked_name.hpp"

namespace moat {

Model::Model() = default;
Model::Model(const Model& other) = default;
Model::Model(Model&& other) noexcept = default;
Model& Model::operator=(const Model& other) = default;
Model& Model::operator=(Model&& other) noexcept = default;
Model::~Model() = default;

ElementBlock& Model::block_of(std::type_index type, std::unique_ptr<ElementBlock> (*make)()) {
  prepared_ = false;
  // They are few.
  const auto found = std::ranges::find(block_types_, type);
  if (found != block_types_.end()) return *blocks_[static_cast<std::size_t>(found - block_types_.begin())];
  block_types_.push_back(type);
  blocks_.emplace_back(make());
  return *blocks_.back();
}

NodeId Model::add_node(Node node) {
  const Check check{"Node", node.name};
  check.that(!node.name.empty(), "a node has no name.", "Give .name: results are listed under it.");
  check_name(check, node.name);
  check.that(node.name != "ground", "this name is taken.", "`ground` is always there; choose another name.");
  check.positive("mass", node.mass, "Every degree of freedom needs mass.");
  check.finite("initial_displacement", node.initial_displacement);
  check.finite("initial_velocity", node.initial_velocity);
  check.positive("half_width", node.half_width);
  check.that(!has_node(node.name), "a node of this name exists.", "Give every node its own name.");
  if (node.direction) {
    constexpr double round_off = 1e-9;
    const double its_length = length(*node.direction);
    check.that(std::abs(its_length - 1.0) <= round_off, "length of direction", its_length, "1", "1",
               "Give the unit vector along which the node moves.");
  }
  check.that(node.direction || !is_plan(), "a node without direction in a model with diaphragms.",
             "Give .direction, or a Diaphragm in place of the node: a model moves on a line or in plan.");
  return append_node(std::move(node));
}

NodeId Model::append_node(Node node) {
  node_names_.insert(node.name);
  nodes_.push_back(std::move(node));
  prepared_ = false;
  ids_.push_back(NodeId{node_count() - 1});
  return ids_.back();
}

const Node& Model::node(NodeId id) const {
  require_node(id, Check{"Model", ""}, "node");
  if (id == ground) throw InputError{"Model: the ground has no mass and no degree of freedom."};
  return nodes_[static_cast<std::size_t>(id.index)];
}

std::string_view Model::node_name(NodeId id) const {
  return id == ground ? std::string_view{"ground"} : std::string_view{node(id).name};
}

void Model::require_node(NodeId id, const Check& check, std::string_view field) const {
  if (id == ground || (id.index >= 0 && id.index < node_count())) return;
  if (id.specified())
    check.that(false, std::string{field} + " is not a node of this model.",
               "Use the NodeId that add(model, Node{...}) returned.");
  check.that(false, std::string{field} + " is not given.", "Set it to a node of this model or to `ground`.");
}

void Model::refuse_entry(NodeId node) const {
  const Check check{"Model", ""};
  require_node(node, check, "node");
  check.that(node != ground, "the ground has no mass.", "Ask for a node.");
  throw InputError{"Model: the node \"" + std::string{node_name(node)} +
                   "\" has no state yet. Make a Transient of the model, or call prepare(), before reading motions."};
}

void Model::register_element(std::string_view kind, const std::string& name) {
  const Check check{kind, name};
  check.that(!name.empty(), "an element has no name.", "Give .name: results are listed under it.");
  check_name(check, name);
  check.that(element_names_.insert(name).second, "an element of this name exists.", "Give every element its own name.");
}

void Model::add_building(Building building) {
  const Check check{"Building", building.name};
  const std::vector<NodeId> nodes = building.nodes();
  check.that(!nodes.empty(), "no floors are given.", "Give .base and .floors, from the lowest up.");
  check_name(check, building.name);
  check.that(!building_names_.contains(building.name), "a building of this name exists.",
             "Give every building its own .name.");
  in_building_.resize(nodes_.size(), false);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    require_node(nodes[i], check, i == 0 && building.base != ground ? "base" : "a floor");
    check.that(nodes[i] != ground, "the ground is among the floors.", "List only nodes with mass.");
    const auto index = static_cast<std::size_t>(nodes[i].index);
    if (in_building_[index] || std::ranges::count(nodes, nodes[i]) > 1)
      check.that(false, "the node \"" + nodes_[index].name + "\" is in a building already.",
                 "Its inertia would count twice.");
  }
  for (const NodeId node : nodes) in_building_[static_cast<std::size_t>(node.index)] = true;
  building_names_.insert(building.name);
  buildings_.push_back(std::move(building));
}

void Model::prepare() {
  if (prepared_) return;
  if (nodes_.empty()) throw InputError{"Model: there is no node. Add nodes with add(model, Node{...}) first."};
  const int count = node_count();
  Couplings couplings{count};
  changing_blocks_.clear();
  constant_blocks_.clear();
  blocks_with_regimes_.clear();
  blocks_with_contacts_.clear();
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    (blocks_[i]->constant_tangent() ? constant_blocks_ : changing_blocks_).push_back(i);
    if (blocks_[i]->regimes() != nullptr) blocks_with_regimes_.push_back(i);
    if (blocks_[i]->contacts() != nullptr) blocks_with_contacts_.push_back(i);
    blocks_[i]->add_couplings(couplings);
  }
  constant_stiffness_ = constant_damping_ = couplings.zero_matrix();
  for (const auto& block : blocks_) block->find_slots(constant_stiffness_);
  ++tangent_version_;
  diagonal_slots_.clear();
  for (int i = 0; i < count; ++i) diagonal_slots_.push_back(entry_position(constant_stiffness_, i, i));

  masses_.resize(count);
  ground_share_x_.setOnes(count);
  ground_share_y_.setZero(count);
  // Nodes added since the last analysis start from their initial values; all others keep their state.
  const Eigen::Index known = std::max<Eigen::Index>(state_.displacement.size() - 1, 0);
  for (Vector* vector : {&state_.displacement, &state_.velocity, &state_.acceleration, &state_.jerk}) {
    vector->conservativeResize(count + 1);
    vector->tail(count + 1 - known).setZero();
  }
  for (int i = 0; i < count; ++i) {
    const Node& node = nodes_[static_cast<std::size_t>(i)];
    masses_[i] = node.mass.si();
    if (node.direction) {
      ground_share_x_[i] = node.direction->x;
      ground_share_y_[i] = node.direction->y;
    }
    if (i < known) continue;
    state_.displacement[i] = node.initial_displacement.si();
    state_.velocity[i] = node.initial_velocity.si();
  }
  trial_ = state_;
  // Evaluate and commit once, so that forces and states of all elements belong to the current state.
  prepared_ = true;
  evaluate();
  for (const auto& block : blocks_) {
    block->evaluate_rates(trial_.acceleration.data(), nullptr);
    block->commit(0.0, WorkRule::mean_force);
  }
  committed_forces_ = internal_forces_;
  for (const std::size_t i : constant_blocks_) {
    blocks_[i]->add_tangent(1.0, 0.0, constant_stiffness_);
    blocks_[i]->add_tangent(0.0, 1.0, constant_damping_);
  }
}

void Model::commit(WorkRule rule) {
  const double step = trial_.time - state_.time;
  state_.time = trial_.time;
  state_.displacement.swap(trial_.displacement);
  state_.velocity.swap(trial_.velocity);
  state_.acceleration.swap(trial_.acceleration);
  state_.jerk.swap(trial_.jerk);
  committed_forces_.swap(internal_forces_);
  for (const auto& block : blocks_) block->commit(step, rule);
}

void Model::start_energy_accounts() {
  keeps_energy_accounts_ = true;
  for (const auto& block : blocks_) block->start_energy_accounts();
}

void Model::return_to_committed_state() {
  if (!prepared_) return;
  undo_changes_inside();
  trial_ = state_;
  evaluate();
  evaluate_rates();
}

}  // namespace moat
