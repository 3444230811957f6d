#include "output/files/building_parts.hpp"

#include <algorithm>
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

void add_elements(const Model& model, const std::set<std::string>& bodies, BuildingParts& parts) {
  for (const auto& block : model.blocks())
    for (const ElementInfo& info : block->infos()) {
      const auto is_at = [&](const std::vector<NodeId>& end) {
        return std::ranges::any_of(end,
                                   [&](NodeId node) { return bodies.contains(std::string{model.body_name(node)}); });
      };
      const auto [nodes_of_first, nodes_of_second] = info.ends();
      const bool first = is_at(nodes_of_first), second = is_at(nodes_of_second);
      if (!first && !second) continue;
      parts.places.insert({info.name, info.listed_under()});
      if (block->kind().contacts && first != second) parts.gaps.push_back({info.name, side_of_gap(info, first)});
    }
}

}  // namespace

std::vector<BuildingParts> parts_of_buildings(const Model& model) {
  std::vector<BuildingParts> list;
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
    std::set<std::string> bodies;
    for (const NodeId node : building.nodes()) bodies.insert(name_of(node));
    parts.places = bodies;
    parts.places.insert(building.base_name());
    for (const StoreyResult& result : building.storey_results) parts.places.insert(result.place);
    add_elements(model, bodies, parts);
    list.push_back(std::move(parts));
  }
  return list;
}

}  // namespace moat
