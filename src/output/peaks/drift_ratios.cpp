#include "output/peaks/drift_ratios.hpp"

#include <map>
#include <string>
#include <string_view>

#include "model/building.hpp"

namespace moat {
namespace {

// m; 0 for the ground.
double height_of(const Model& model, NodeId node) { return node == ground ? 0.0 : model.body(node).height; }

// The heights of storeys, m, by the places of their drifts: elements, storeys of superstructures, in plan floors.
std::map<std::string, double> heights_of_storeys(const Model& model) {
  std::map<std::string, double> heights;
  for (const auto& block : model.blocks())
    for (const ElementInfo& info : block->infos())
      if (info.deformation_quantity == "drift")
        heights[info.listed_under()] = height_of(model, info.second) - height_of(model, info.first);
  for (const Building& building : all_buildings(model)) {
    double below = height_of(model, building.base);
    int number = 0;
    for (const NodeId floor : building.floors) {
      const double level = height_of(model, floor);
      const std::string storey =
          (building.name.empty() ? "" : building.name + " ") + "storey " + std::to_string(++number);
      heights.try_emplace(model.is_plan() ? std::string{model.body_name(floor)} : storey, level - below);
      below = level;
    }
  }
  return heights;
}

}  // namespace

std::vector<Peak> drift_ratios(const Model& model, const std::vector<Peak>& peaks) {
  const std::map<std::string, double> heights = heights_of_storeys(model);
  const std::map<std::string_view, const char*> ratios{{"drift", "drift_ratio"},
                                                       {"corner_drift", "corner_drift_ratio"},
                                                       {"drift_x", "drift_ratio_x"},
                                                       {"drift_y", "drift_ratio_y"}};
  std::vector<Peak> list;
  for (const Peak& drift : peaks) {
    const auto ratio = ratios.find(drift.quantity);
    const auto height = heights.find(drift.where);
    if (ratio == ratios.end() || height == heights.end() || !(height->second > 0.0)) continue;
    const double percent = 100.0 / height->second;
    Peak& added = list.emplace_back(drift);
    added.quantity = ratio->second;
    added.value *= percent;
    added.error *= percent;
    added.unit = "%";
  }
  return list;
}

}  // namespace moat
