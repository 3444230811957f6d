#include "output/recorders/isolator_forces.hpp"

#include <cmath>

#include "model/building.hpp"
#include "model/model.hpp"

namespace moat {

IsolatorForces::IsolatorForces(const Model& model) : is_plan_{model.is_plan()} {
  const std::vector<std::vector<ElementId>> isolators = isolators_of(model, model.buildings());
  for (std::size_t b = 0; b < isolators.size(); ++b) {
    if (isolators[b].empty()) continue;
    Sum& sum = sums_.emplace_back(Sum{.where = model.buildings()[b].base_name()});
    for (const ElementId id : isolators[b]) {
      const ElementInfo& info = model.blocks()[id.block]->info(id.element);
      if (is_plan_ && info.plan_places() == nullptr) continue;
      const PlanVector direction = is_plan_ ? info.plan_places()->direction : PlanVector{1.0, 0.0};
      const double sign = info.second == ground ? -1.0 : 1.0;
      sum.parts.push_back({id.block, id.element, info.acts_in_two_directions(), sign * direction});
    }
  }
}

void IsolatorForces::step(const StepView& view) {
  const auto keep = [&](double force, double& largest, double& time) {
    if (std::abs(force) <= std::abs(largest)) return;
    largest = force;
    time = view.state.time();
  };
  for (Sum& sum : sums_) {
    PlanVector force{};
    for (const Part& part : sum.parts) {
      const ElementResults results = view.state.elements(part.block).results();
      force += part.in_two_directions ? results.plan.forces[part.element]
                                      : results.line.forces[part.element] * part.direction;
    }
    keep(force.x, sum.largest.x, sum.time_of_x);
    keep(force.y, sum.largest.y, sum.time_of_y);
  }
}

std::vector<Peak> IsolatorForces::peaks() const {
  const std::string quantity = "total_isolator_force";
  std::vector<Peak> list;
  for (const Sum& sum : sums_) {
    list.push_back({quantity + (is_plan_ ? "_x" : ""), sum.where, sum.largest.x, "N", sum.time_of_x});
    if (is_plan_) list.push_back({quantity + "_y", sum.where, sum.largest.y, "N", sum.time_of_y});
  }
  return list;
}

}  // namespace moat
