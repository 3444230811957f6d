#include "output/recorders/storey_shears.hpp"

#include <map>
#include <string>

#include "model/building.hpp"

namespace moat {

StoreyShears::StoreyShears(const Model& model, const std::vector<std::pair<NodeId, NodeId>>& storeys)
    : sums_(storeys.size()), shears_(storeys.size()) {
  std::map<std::pair<int, int>, std::size_t> numbers;
  for (const auto& [lower, upper] : storeys) numbers.emplace(std::pair{lower.index, upper.index}, numbers.size());
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const ElementBlock& block = *model.blocks()[b];
    if (block.kind().contacts) continue;
    for (std::size_t e = 0; e < block.size(); ++e) {
      const ElementInfo& info = block.info(e);
      const auto storey = numbers.find({info.first.index, info.second.index});
      const bool carries = model.is_plan() ? info.plan_places() != nullptr : !info.force_quantity.empty();
      if (storey != numbers.end() && carries) parts_.push_back({b, e, storey->second});
    }
  }
  std::vector<bool> has_parts(storeys.size(), false);
  for (const Part& part : parts_) has_parts[part.storey] = true;
  for (const Building& building : model.buildings()) {
    NodeId below = building.base;
    for (std::size_t i = 0; i < building.floors.size(); ++i) {
      const auto storey = numbers.find({below.index, building.floors[i].index});
      below = building.floors[i];
      const std::string place = (building.name.empty() ? "" : building.name + " ") + "storey " + std::to_string(i + 1);
      for (const StoreyResult& result : building.storey_results)
        if (storey != numbers.end() && !has_parts[storey->second] && result.place == place &&
            result.quantity.starts_with("storey_shear"))
          sums_of_motion_.push_back({storey->second,
                                     result.quantity.ends_with("_y") ? PlanVector{0.0, 1.0} : PlanVector{1.0, 0.0},
                                     result.displacements});
    }
  }
}

std::span<const double> StoreyShears::evaluate(const AnalysisState& state) {
  const Model& model = state.model();
  for (PlanVector& sum : sums_) sum = {};
  for (const Part& part : parts_) {
    const ElementInfo& info = model.blocks()[part.block]->info(part.element);
    const ElementResults results = state.elements(part.block).results();
    const PlanVector along = model.is_plan() ? info.plan_places()->direction : PlanVector{1.0, 0.0};
    sums_[part.storey] +=
        info.acts_in_two_directions() ? results.plan.forces[part.element] : results.line.forces[part.element] * along;
  }
  for (const SumOfMotion& sum : sums_of_motion_)
    for (const MotionShare& share : sum.displacements)
      sums_[sum.storey] += share.weight * state.displacement(share.node) * sum.along;
  for (std::size_t i = 0; i < sums_.size(); ++i) shears_[i] = model.is_plan() ? length(sums_[i]) : sums_[i].x;
  return shears_;
}

}  // namespace moat
