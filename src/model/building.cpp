#include "model/building.hpp"

#include "model/model.hpp"
#include "model/node_sets.hpp"

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

}  // namespace

std::vector<NodeId> Building::nodes() const {
  std::vector<NodeId> list;
  list.reserve(floors.size() + 1);
  if (base != ground) list.push_back(base);
  list.insert(list.end(), floors.begin(), floors.end());
  return list;
}

std::vector<std::vector<ElementId>> isolators_of(const Model& model, std::span<const Building> buildings) {
  constexpr int none = -1;
  std::vector<int> building_of_node(static_cast<std::size_t>(model.degrees_of_freedom()), none);
  for (std::size_t b = 0; b < buildings.size(); ++b)
    for (const NodeId node : buildings[b].nodes())
      building_of_node[static_cast<std::size_t>(node.index)] = static_cast<int>(b);
  std::vector<std::vector<ElementId>> found(buildings.size());
  for_each_element(model, [&](ElementId id, const ElementInfo& info) {
    const NodeId node = isolated_node(info);
    if (node == ground) return;
    const int building = building_of_node[static_cast<std::size_t>(node.index)];
    if (building != none) found[static_cast<std::size_t>(building)].push_back(id);
  });
  return found;
}

std::vector<int> connected_parts(const Model& model) {
  NodeSets parts{model.degrees_of_freedom()};
  for (const Body& body : model.bodies())
    for (const NodeId node : model.body_of(body.first)) parts.join(body.first.index, node.index);
  for_each_element(model, [&](ElementId id, const ElementInfo& info) {
    if (!model.blocks()[id.block]->kind().contacts) parts.join(info.first.index, info.second.index);
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
      building_of_part[static_cast<std::size_t>(part[static_cast<std::size_t>(node.index)])] = known;
  std::vector<bool> isolated(part.size(), false);
  for_each_element(model, [&](ElementId, const ElementInfo& info) {
    if (const NodeId node = isolated_node(info); node != ground) isolated[static_cast<std::size_t>(node.index)] = true;
  });
  for (int node = 0; node < model.degrees_of_freedom(); ++node) {
    // A diaphragm counts once.
    if (model.body_of(NodeId{node}).front() != NodeId{node}) continue;
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

}  // namespace moat
