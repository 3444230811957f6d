#include "design/sheet_building_of.hpp"

#include <algorithm>
#include <vector>

#include "analyses/modes/periods.hpp"

namespace moat {

SheetBuilding sheet_building_of(const Model& model, const SheetIsolation& isolation, const std::string& base) {
  const Check check{"sheet_building_of", base};
  const auto found = std::ranges::find_if(model.buildings(), [&](const Building& each) {
    return !each.shares_base && each.base != ground && model.body_name(each.base) == base;
  });
  check.that(found != model.buildings().end() && model.diaphragm_of(found->base) != nullptr,
             "the model has no building in plan on this base.", "Give the name of the base of a building in plan.");
  const PlacedDiaphragm& slab = *model.diaphragm_of(found->base);
  check.that(!slab.outline.empty(), "the base has no outline.", "Give its corners, for the sides of the plan.");
  const auto side = [&](Length PlanPosition::*along) {
    const auto [low, high] = std::ranges::minmax(slab.outline.corners, {}, along);
    return high.*along - low.*along;
  };
  const auto [shorter, longer] = std::minmax({side(&PlanPosition::x), side(&PlanPosition::y)});
  SheetBuilding building{.name = found->name,
                         .weight = Force{},
                         .isolation = isolation,
                         .shorter_side = shorter,
                         .longer_side = longer,
                         .fixed_base_period = Time{fixed_base_period(model, *found)}};
  double mass = 0.0;
  PlanVector moment{};
  for (const NodeId node : carried_nodes(model, *found)) {
    const PlacedDiaphragm* floor = model.diaphragm_of(node);
    if (floor == nullptr) continue;
    mass += floor->mass;
    moment += floor->mass * floor->centre_of_mass;
    const bool is_slab = node == found->base || std::ranges::find(found->slabs, node) != found->slabs.end();
    if (!is_slab) building.floors.push_back({Mass{floor->mass} * units::g, Length{floor->height - slab.height}});
  }
  building.weight = Mass{mass} * units::g;
  PlanVector centre{};
  const std::vector<ElementId> isolators = isolators_of(model, {&*found, 1}).front();
  for (const ElementId id : isolators) {
    const ElementInfo& info = model.blocks()[id.block]->info(id.element);
    if (info.plan_places() == nullptr) continue;
    const PlanVector at = info.plan_places()->second;
    centre += at;
    building.bearings.push_back({Length{at.x}, Length{at.y}});
  }
  check.that(!building.bearings.empty(), "there are no isolators under the base.", "Give bearings.");
  centre = (1.0 / static_cast<double>(building.bearings.size())) * centre;
  building.eccentricity = Length{length((1.0 / mass) * moment - centre)};
  return building;
}

}  // namespace moat
