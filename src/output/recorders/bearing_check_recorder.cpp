#include "output/recorders/bearing_check_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace moat {
namespace {

// On an element, N; NaN for one that is no bearing of a building with AxialForces.
double compression_on(const StepView& view, std::size_t block, std::size_t element) {
  for (const WeightOnBearings& weight : view.state.weights())
    for (const WeightOnBearings::Bearing& bearing : weight.bearings())
      if (bearing.element.block == block && bearing.element.element == element)
        return bearing.deficit > 0.0 ? 0.0 : bearing.compression;
  return std::numeric_limits<double>::quiet_NaN();
}

DemandAt demand_at(const StepView& view, std::size_t block, std::size_t element, double count) {
  const ElementResults results = view.state.elements(block).results();
  const ElementResult of_element = results[element];
  const bool in_plan = !results.plan.forces.empty();
  return {.displacement = in_plan ? results.plan.deformations[element] : PlanVector{of_element.deformation},
          .speed = in_plan ? length(results.plan.rates[element]) : std::abs(of_element.rate),
          .force = std::abs(of_element.force) / count,
          .compression = compression_on(view, block, element) / count,
          .time = view.state.time()};
}

}  // namespace

BearingCheckRecorder::BearingCheckRecorder(CheckRules rules, std::map<std::string, BearingCapacities> capacities)
    : rules_{rules}, capacities_{std::move(capacities)} {
  for (const auto& [name, each] : capacities_) each.check(Check{"BearingCapacities", name});
}

void BearingCheckRecorder::start(const StepView& view) {
  bearings_.clear();
  std::set<std::string> found;
  const auto& blocks = view.model.blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t e = 0; e < blocks[b]->size(); ++e) {
      const ElementInfo& info = blocks[b]->info(e);
      auto of_element = capacities_.find(info.name);
      if (of_element == capacities_.end()) of_element = capacities_.find(info.listed_under());
      if (of_element == capacities_.end()) continue;
      found.insert(of_element->first);
      const LawAsGiven law = blocks[b]->law(e);
      bearings_.push_back({b, e, parameter_of(law.parameters, "count", 1.0), info.name,
                           info.place.empty() ? law.name : info.place, BearingChecks{of_element->second, rules_}});
    }
  for (const auto& [name, each] : capacities_)
    Check{"BearingCheckRecorder", name}.that(
        found.contains(name), "no element has this name or type.",
        "Give the name of a bearing, or the one under which its peaks are listed.");
  step(view);
}

void BearingCheckRecorder::step(const StepView& view) {
  for (Bearing& bearing : bearings_)
    bearing.checks.take(demand_at(view, bearing.block, bearing.element, bearing.count));
}

std::vector<BearingCheckRow> BearingCheckRecorder::rows() const {
  std::vector<BearingCheckRow> rows;
  for (const Bearing& bearing : bearings_)
    for (const BearingDemand& demand : bearing.checks.largest()) rows.push_back({bearing.name, bearing.type, demand});
  return rows;
}

}  // namespace moat
