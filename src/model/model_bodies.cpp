// The bodies of a model that nothing connects.
#include <cstddef>
#include <span>
#include <typeindex>
#include <vector>

#include "model/model.hpp"
#include "model/node_sets.hpp"
#include "model/numbers_in_part.hpp"

namespace moat {
namespace {

NodeSets bodies_of(const Model& model) {
  NodeSets bodies{model.node_count()};
  const SparsityPattern& pattern = *model.pattern();
  for (int column = 0; column < pattern.size; ++column)
    for (int k = pattern.column_starts[static_cast<std::size_t>(column)];
         k < pattern.column_starts[static_cast<std::size_t>(column) + 1]; ++k)
      bodies.join(column, pattern.row_indices[static_cast<std::size_t>(k)]);
  for (const Building& building : model.buildings())
    for (const NodeId node : building.nodes()) bodies.join(building.nodes().front().index, node.index);
  for (const PlacedDiaphragm& diaphragm : model.diaphragms())
    for (const NodeId node : diaphragm.id.degrees_of_freedom()) bodies.join(diaphragm.id.x.index, node.index);
  // A model without diaphragms moves on a line: a node that moves in plan stays with one.
  if (model.is_plan())
    for (int i = 0; i < model.node_count(); ++i)
      if (model.diaphragm_of(NodeId{i}) == nullptr && bodies.first_of(i) == i)
        bodies.join(i, model.diaphragms().front().id.x.index);
  return bodies;
}

// A node of an element; the ground if it has none.
NodeId any_node_of(const ElementInfo& info) {
  for (const NodeId node : {info.first, info.second})
    if (node != ground) return node;
  if (const MemberEnds* ends = info.member_ends())
    for (const NodeId node : {ends->first.other, ends->second.other})
      if (node != ground) return node;
  return ground;
}

}  // namespace

std::vector<Model> Model::unconnected_bodies() const {
  const std::vector<int> body_of_node = bodies_of(*this).numbers();
  const auto body_of = [&](int node) { return static_cast<std::size_t>(body_of_node[static_cast<std::size_t>(node)]); };
  std::vector<std::vector<std::size_t>> nodes;  // of every body
  std::vector<int> numbers(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::size_t body = body_of(static_cast<int>(i));
    if (body == nodes.size()) nodes.emplace_back();
    numbers[i] = static_cast<int>(nodes[body].size());
    nodes[body].push_back(i);
  }
  if (nodes.size() < 2) return {};
  // Of every body, by block.
  std::vector<std::vector<std::vector<std::size_t>>> elements(nodes.size());
  for (auto& of_body : elements) of_body.resize(blocks_.size());
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (std::size_t e = 0; e < blocks_[b]->size(); ++e)
      if (const NodeId node = any_node_of(blocks_[b]->info(e)); node != ground)
        elements[body_of(node.index)][b].push_back(e);
  const NumbersInPart in_part{std::move(numbers)};
  std::vector<Model> bodies;
  bodies.reserve(nodes.size());
  for (std::size_t body = 0; body < nodes.size(); ++body) bodies.push_back(part(nodes[body], elements[body], in_part));
  for (const Building& building : buildings_) {
    Building its = building;
    its.base = in_part.of(building.base);
    for (NodeId& floor : its.floors) floor = in_part.of(floor);
    bodies[body_of(building.nodes().front().index)].add_building(std::move(its));
  }
  for (Model& body : bodies) body.prepare();
  return bodies;
}

Model Model::part(std::span<const std::size_t> nodes, const std::vector<std::vector<std::size_t>>& elements,
                  const NumbersInPart& numbers) const {
  Model part;
  for (const std::size_t node : nodes) {
    const NodeId id = part.append_node(nodes_[node]);
    const PlacedDiaphragm* diaphragm = diaphragm_of(NodeId{static_cast<int>(node)});
    if (diaphragm == nullptr) continue;
    if (diaphragm->id.x == NodeId{static_cast<int>(node)}) {
      part.diaphragms_.push_back(*diaphragm);
      part.diaphragms_.back().id = {numbers.of(diaphragm->id.x), numbers.of(diaphragm->id.y),
                                    numbers.of(diaphragm->id.r)};
    }
    part.diaphragm_of_node_.resize(part.nodes_.size(), -1);
    part.diaphragm_of_node_[static_cast<std::size_t>(id.index)] = static_cast<int>(part.diaphragms_.size()) - 1;
  }
  // Blocks stand in the order of the whole model.
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (elements[b].empty()) continue;
    part.block_types_.push_back(block_types_[b]);
    part.blocks_.emplace_back(blocks_[b]->part(elements[b], numbers));
    for (std::size_t e = 0; e < elements[b].size(); ++e) part.element_names_.add(part.blocks_.back()->info(e).name);
  }
  part.state_.time = state_.time;
  part.state_.ground_motion = state_.ground_motion;
  for (Vector MotionState::*values :
       {&MotionState::displacement, &MotionState::velocity, &MotionState::acceleration, &MotionState::jerk}) {
    (part.state_.*values).setZero(static_cast<Eigen::Index>(nodes.size()) + 1);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      (part.state_.*values)[static_cast<Eigen::Index>(i)] = (state_.*values)[static_cast<Eigen::Index>(nodes[i])];
  }
  return part;
}

}  // namespace moat
