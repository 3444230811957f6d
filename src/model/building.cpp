#include "model/building.hpp"

#include <algorithm>
#include <numeric>

#include "model/model.hpp"

namespace moat {
namespace {

template <class Action>
void for_each_element(const Model& model, const Action& action) {
  for (std::size_t b = 0; b < model.blocks().size(); ++b)
    for (std::size_t e = 0; e < model.blocks()[b]->size(); ++e) action(ElementId{b, e}, model.blocks()[b]->info(e));
}

// The node that an isolator separates from the ground; `ground` if it is no such element.
NodeId isolated_node(const ElementInfo& info) {
  if (!info.isolates) return ground;
  if (info.first == ground) return info.second;
  return info.second == ground ? info.first : ground;
}

/// Every node is a set at first; sets are joined.
class NodeSets {
 public:
  /// Makes a set of each of the nodes 0 to count - 1.
  explicit NodeSets(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// The sets of two nodes become one; a node below zero, the ground, joins nothing.
  void join(int a, int b) {
    if (a < 0 || b < 0) return;
    a = first_of(a);
    b = first_of(b);
    at(std::max(a, b)) = std::min(a, b);
  }
  /// The first node of the set of a node.
  int first_of(int node) {
    while (at(node) != node) {
      // Halves the way to the first node for the next visit.
      at(node) = at(at(node));
      node = at(node);
    }
    return node;
  }
  /// The number of its set for every node, 0, 1, ... in the order of their first nodes.
  std::vector<int> numbers() {
    std::vector<int> number(parent_.size());
    int count = 0;
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i) {
      const int first = first_of(i);
      number[static_cast<std::size_t>(i)] = first == i ? count++ : number[static_cast<std::size_t>(first)];
    }
    return number;
  }

 private:
  int& at(int node) { return parent_[static_cast<std::size_t>(node)]; }

  std::vector<int> parent_;
};

}  // namespace

std::vector<NodeId> Building::nodes() const {
  std::vector<NodeId> list;
  if (base != ground && !shares_base) list.push_back(base);
  list.insert(list.end(), slabs.begin(), slabs.end());
  list.insert(list.end(), floors.begin(), floors.end());
  return list;
}

std::vector<NodeId> carried_nodes(const Model& model, const Building& building) {
  std::vector<NodeId> nodes;
  if (building.shares_base) return nodes;
  nodes = building.nodes();
  for (const Building& other : model.buildings())
    if (other.shares_base && std::ranges::count(nodes, other.base) > 0)
      for (const NodeId node : other.nodes()) nodes.push_back(node);
  return nodes;
}

std::vector<std::vector<ElementId>> isolators_of(const Model& model, std::span<const Building> buildings) {
  constexpr int none = -1;
  std::vector<int> building_of_node(static_cast<std::size_t>(model.nodes()), none);
  for (std::size_t b = 0; b < buildings.size(); ++b)
    for (const NodeId node : buildings[b].nodes())
      building_of_node[static_cast<std::size_t>(model.place(node))] = static_cast<int>(b);
  std::vector<std::vector<ElementId>> found(buildings.size());
  for_each_element(model, [&](ElementId id, const ElementInfo& info) {
    const NodeId node = isolated_node(info);
    if (node == ground) return;
    const int building = building_of_node[static_cast<std::size_t>(model.place(node))];
    if (building != none) found[static_cast<std::size_t>(building)].push_back(id);
  });
  return found;
}

std::vector<int> connected_parts(const Model& model) {
  NodeSets parts{model.nodes()};
  for (const Body& body : model.bodies())
    for (const NodeId node : model.nodes_of_body(body.first))
      for (const NodeId moving : model.body_of(body.first)) parts.join(moving.index, model.place(node));
  for_each_element(model, [&](ElementId id, const ElementInfo& info) {
    if (model.blocks()[id.block]->kind().contacts) return;
    parts.join(model.place(info.first), model.place(info.second));
    if (const std::vector<NodeId>* joined = info.joined())
      for (const NodeId node : *joined) parts.join(joined->front().index, node.index);
  });
  return parts.numbers();
}

std::vector<Building> all_buildings(const Model& model) {
  std::vector<Building> buildings = model.buildings();
  const std::vector<int> part = connected_parts(model);
  constexpr int none = -1, known = -2;
  std::vector<int> building_of_part(part.size(), none);
  for (const Building& building : buildings)
    for (const NodeId node : building.nodes())
      building_of_part[static_cast<std::size_t>(part[static_cast<std::size_t>(model.place(node))])] = known;
  std::vector<bool> isolated(part.size(), false);
  for_each_element(model, [&](ElementId, const ElementInfo& info) {
    if (const NodeId node = isolated_node(info); node != ground)
      isolated[static_cast<std::size_t>(model.place(node))] = true;
  });
  for (int node = 0; node < model.degrees_of_freedom(); ++node) {
    // A diaphragm counts once.
    if (model.body(NodeId{node}).first != NodeId{node}) continue;
    int& building = building_of_part[static_cast<std::size_t>(part[static_cast<std::size_t>(node)])];
    if (building == known) continue;
    if (building == none) {
      building = static_cast<int>(buildings.size());
      buildings.push_back({.name = std::string{model.body_name(NodeId{node})}});
    }
    Building& its = buildings[static_cast<std::size_t>(building)];
    if (isolated[static_cast<std::size_t>(node)] && its.base == ground)
      its.base = NodeId{node};
    else
      its.floors.push_back(NodeId{node});
  }
  return buildings;
}

std::vector<std::string> bodies_beside_buildings(const Model& model) {
  std::vector<std::string> names;
  if (model.buildings().empty()) return names;
  const std::vector<Building> buildings = all_buildings(model);
  for (std::size_t b = model.buildings().size(); b < buildings.size(); ++b)
    if (buildings[b].base == ground && buildings[b].floors.size() == 1) names.push_back(buildings[b].name);
  return names;
}

}  // namespace moat
