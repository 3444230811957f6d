#include "output/recorders/storey_shears.hpp"

#include <map>

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
  for (std::size_t i = 0; i < sums_.size(); ++i) shears_[i] = model.is_plan() ? length(sums_[i]) : sums_[i].x;
  return shears_;
}

}  // namespace moat
