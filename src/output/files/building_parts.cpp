#include "output/files/building_parts.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "model/model.hpp"

namespace moat {
namespace {

// Where a building touches at a gap: on a line the side of the gap, in plan the edge, or its own edge that a corner of
// another body meets. The right side of a gap on a line is its first node; in plan the second body has the corner.
std::string side_of_gap(const ElementInfo& gap, bool is_first) {
  const CornerPair* pair = gap.corner_pair();
  if (pair != nullptr) return is_first ? pair->corner : pair->edge;
  return is_first ? "left" : "right";
}

/// The buildings of a body, by its name: several where they share a base.
using BuildingsOfBodies = std::map<std::string, std::set<std::size_t>, std::less<>>;

void add_elements(const Model& model, const BuildingsOfBodies& buildings_of, const std::vector<std::string>& walls,
                  std::vector<BuildingParts>& list) {
  const auto buildings_at = [&](const std::vector<NodeId>& end) {
    std::set<std::size_t> at;
    for (const NodeId node : end)
      if (const auto found = buildings_of.find(model.body_name(node)); found != buildings_of.end())
        at.insert(found->second.begin(), found->second.end());
    return at;
  };
  for (const auto& block : model.blocks())
    for (const ElementInfo& info : block->infos()) {
      const auto [nodes_of_first, nodes_of_second] = info.ends();
      const std::set<std::size_t> first = buildings_at(nodes_of_first), second = buildings_at(nodes_of_second);
      for (const std::set<std::size_t>* end : {&first, &second})
        for (const std::size_t building : *end) {
          list[building].places.insert({info.name, info.listed_under()});
          if (!block->kind().contacts || first.contains(building) == second.contains(building)) continue;
          const bool is_first = end == &first;
          std::string wall;
          for (const NodeId node : is_first ? nodes_of_second : nodes_of_first)
            if (std::ranges::find(walls, model.body_name(node)) != walls.end()) wall = model.body_name(node);
          list[building].gaps.push_back({info.name, side_of_gap(info, is_first), std::move(wall)});
        }
    }
}

}  // namespace

std::vector<BuildingParts> parts_of_buildings(const Model& model) {
  std::vector<BuildingParts> list;
  BuildingsOfBodies buildings_of;
  const auto name_of = [&](NodeId node) { return std::string{model.body_name(node)}; };
  const std::vector<Building> buildings = all_buildings(model);
  const std::vector<std::string> bodies_beside = bodies_beside_buildings(model);
  const std::vector<std::vector<ElementId>> isolators = isolators_of(model, buildings);
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    const Building& building = buildings[b];
    BuildingParts parts{.name = building.name, .base = building.base == ground ? "" : name_of(building.base)};
    for (const NodeId floor : building.floors) parts.floors.push_back(name_of(floor));
    parts.modes = building.modes;
    parts.is_body_beside_buildings = std::ranges::find(bodies_beside, building.name) != bodies_beside.end();
    for (const ElementId id : isolators[b]) parts.isolators.push_back(model.blocks()[id.block]->info(id.element).name);
    for (const NodeId node : building.nodes()) {
      parts.places.insert(name_of(node));
      buildings_of[name_of(node)].insert(b);
    }
    parts.places.insert(building.base_name());
    for (const StoreyResult& result : building.storey_results) parts.places.insert(result.place);
    list.push_back(std::move(parts));
  }
  add_elements(model, buildings_of, bodies_beside, list);
  return list;
}

}  // namespace moat
