#include "model/model.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"

namespace moat {

Model::Model() = default;
Model::Model(const Model& other) = default;
Model::Model(Model&& other) noexcept = default;
Model& Model::operator=(const Model& other) = default;
Model& Model::operator=(Model&& other) noexcept = default;
Model::~Model() = default;

ElementBlock& Model::block_of(std::type_index type, std::unique_ptr<ElementBlock> (*make)()) {
  ++additions_;
  // They are few.
  const auto found = std::ranges::find(block_types_, type);
  if (found != block_types_.end()) return *blocks_[static_cast<std::size_t>(found - block_types_.begin())];
  block_types_.push_back(type);
  blocks_.emplace_back(make());
  return *blocks_.back();
}

void Model::register_element(std::string_view kind, const std::string& name) {
  const Check check{kind, name};
  check.that(!name.empty(), "an element has no name.", "Give .name: results are listed under it.");
  check.fits_tables(name);
  check.that(element_names_.insert(name).second, "an element of this name exists.", "Give every element its own name.");
}

void Model::add_building(Building building) {
  const Check check{"Building", building.name};
  const std::vector<NodeId> nodes = building.nodes();
  check.that(!nodes.empty(), "no floors are given.", "Give .base and .floors, from the lowest up.");
  check.fits_tables(building.name);
  check.that(!building_names_.contains(building.name), "a building of this name exists.",
             "Give every building its own .name.");
  check.that(!building.axial_forces || !building.shares_base,
             "axial_forces are asked of a building on the base of another one.",
             "Give them to the building that has the bearings.");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    require_node(nodes[i], check, i == 0 && building.base != ground ? "base" : "a floor");
    check.that(nodes[i] != ground, "the ground is among the floors.", "List only nodes with mass.");
    check.that(!in_building_.contains(nodes[i].index) && std::ranges::count(nodes, nodes[i]) == 1,
               "the node \"" + std::string{node_name(nodes[i])} + "\" is in a building already.",
               "Its inertia would count twice.");
  }
  for (const NodeId node : nodes) in_building_.insert(node.index);
  building_names_.insert(building.name);
  buildings_.push_back(std::move(building));
  ++additions_;
}

const Body& Model::body(NodeId node) const {
  require_node(node, Check{"Model", ""}, "node");
  if (node == ground) throw InputError{"Model: the ground has no mass and no degree of freedom."};
  return bodies_[node.is_follower() ? follower(node).body : body_of_[static_cast<std::size_t>(node.index)]];
}

double Model::mass(NodeId node) const {
  static_cast<void>(body(node));
  return node.is_follower() ? follower(node).mass : given_masses_[static_cast<std::size_t>(node.index)];
}

double Model::moved_by_ground(NodeId node, GroundVector a) const {
  static_cast<void>(body(node));
  if (!node.is_follower()) return ground_influence().times(a, node.index);
  const GroundVector& influence = follower(node).influence;
  return influence.x * a.x + influence.y * a.y + influence.z * a.z;
}

std::vector<NodeId> Model::nodes_of_body(NodeId node) const {
  std::vector<NodeId> list;
  for (int i = 0; node != ground && i < body(node).nodes; ++i) list.push_back(NodeId{body(node).first.index + i});
  return list;
}

std::vector<NodeId> Model::body_of(NodeId node) const {
  std::vector<NodeId> list;
  for (const NodeId each : nodes_of_body(node))
    for (const MotionShare& share : shares(each))
      if (std::ranges::find(list, share.node) == list.end()) list.push_back(share.node);
  return list;
}

std::vector<NodeId> Model::struck_by(const ElementInfo& element) const {
  std::vector<NodeId> list;
  const auto is_struck = [&](NodeId each) { return std::ranges::find(list, each) != list.end(); };
  const auto strike = [&](NodeId each) {
    if (!is_struck(each)) list.push_back(each);
  };
  for (const std::vector<NodeId>& end : element.ends())
    for (const NodeId node : end)
      for (const NodeId own : body_of(node)) {
        strike(own);
        for (const int index : mass_.coupled_with(own.index)) strike(NodeId{index});
      }
  for (int place = degrees_of_freedom(); place < nodes(); ++place)
    if (std::ranges::any_of(shares(this->node(place)), is_struck, &MotionShare::node))
      list.push_back(this->node(place));
  return list;
}

std::span<const MotionShare> Model::shares(NodeId node) const {
  if (node == ground) return {};
  require_node(node, Check{"Model", ""}, "node");
  if (node.is_follower()) return follower(node).shares;
  return std::span{own_shares_}.subspan(static_cast<std::size_t>(node.index), 1);
}

const PlacedDiaphragm& Model::diaphragm(DiaphragmId id) const {
  const PlacedDiaphragm* found = diaphragm_of(id.x);
  if (found == nullptr || found->id != id)
    throw InputError{
        "Model: this is not a diaphragm of the model. Use the DiaphragmId that add(model, Diaphragm{...}) "
        "returned."};
  return *found;
}

const PlacedDiaphragm* Model::diaphragm_of(NodeId node) const {
  if (!is_known(node)) return nullptr;
  const std::optional<std::size_t> index = body(node).diaphragm;
  return index ? &diaphragms_[*index] : nullptr;
}

std::string_view Model::node_name(NodeId id) const {
  if (id == ground) return "ground";
  require_node(id, Check{"Model", ""}, "node");
  return id.is_follower() ? follower(id).name : names_[static_cast<std::size_t>(id.index)];
}

std::string_view Model::body_name(NodeId id) const { return id == ground ? "ground" : std::string_view{body(id).name}; }

void Model::require_node(NodeId id, const Check& check, std::string_view field) const {
  if (id == ground || is_known(id)) return;
  if (id.specified())
    check.that(false, std::string{field} + " is not a node of this model.",
               "Use the NodeId that add(model, Node{...}) returned.");
  check.that(false, std::string{field} + " is not given.", "Set it to a node of this model or to `ground`.");
}

MotionState Model::initial_motion() const {
  const Eigen::Index count = degrees_of_freedom();
  MotionState motion;
  for (Vector* values : {&motion.displacement, &motion.velocity, &motion.acceleration, &motion.jerk})
    values->setZero(count + 1);
  motion.displacement.head(count) = Eigen::Map<const Vector>{initial_displacement_.data(), count};
  motion.velocity.head(count) = Eigen::Map<const Vector>{initial_velocity_.data(), count};
  return motion;
}

SparseMatrix Model::zero_matrix() const {
  if (names_.empty()) throw InputError{"Model: there is no node. Add nodes with add(model, Node{...}) first."};
  Couplings couplings{degrees_of_freedom()};
  mass_.add_couplings(couplings);
  for (const auto& block : blocks_) block->add_couplings(couplings);
  return couplings.zero_matrix();
}

SparseMatrix Model::linear_stiffness(StiffnessStage stage) const {
  SparseMatrix matrix = zero_matrix();
  for (const auto& block : blocks_)
    for (std::size_t e = 0; !block->kind().contacts && e < block->size(); ++e)
      block->add_stiffness(e, block->linear_stiffness(e, stage), matrix);
  return matrix;
}

}  // namespace moat
