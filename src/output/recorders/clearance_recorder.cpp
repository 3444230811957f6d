#include "output/recorders/clearance_recorder.hpp"

#include <limits>
#include <utility>

#include "base/hermite.hpp"

namespace moat {
namespace {

// m, m/s; of a corner minus its distance from the edge.
std::pair<double, double> indentation_of(const ElementBlock& block, std::size_t element) {
  const PlanContacts* corners = block.plan_contacts();
  if (corners == nullptr) {
    const ElementResults results = block.results();
    return {results.deformations[element], results.rates[element]};
  }
  const auto [value, rate] = corners->distance(element);
  return {-value, -rate};
}

}  // namespace

ClearanceRecorder::ClearanceRecorder(const Model& model) : model_{&model} {
  constexpr double none = -std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    if (model.blocks()[b]->contacts() == nullptr) continue;
    for (std::size_t e = 0; e < model.blocks()[b]->size(); ++e) gaps_.push_back({b, e, none, 0.0, none, 0.0});
  }
}

void ClearanceRecorder::step(const StepView& view) {
  const double time = view.model.state().time, step = time - time_before_;
  for (Gap& gap : gaps_) {
    const ElementBlock& block = *view.model.blocks()[gap.block];
    const auto [indentation, rate] = indentation_of(block, gap.element);
    if (indentation > gap.largest) {
      gap.largest = indentation;
      gap.time = time;
    }
    // The two sides came near and went apart again inside the step.
    if (gap.rate > 0.0 && rate < 0.0 && step > 0.0) {
      const HermiteCubic cubic{gap.indentation, gap.rate, indentation, rate, step};
      const double x = cubic.turn();
      if (cubic.is_smooth() && cubic.value(x) > gap.largest) {
        gap.largest = cubic.value(x);
        gap.time = time_before_ + x * step;
      }
    }
    gap.indentation = indentation;
    gap.rate = rate;
  }
  time_before_ = time;
}

std::vector<GapClearance> ClearanceRecorder::clearances() const {
  std::vector<GapClearance> list;
  for (const Gap& gap : gaps_) {
    const ElementBlock& block = *model_->blocks()[gap.block];
    const ElementInfo& info = block.info(gap.element);
    const PlanContacts* corners = block.plan_contacts();
    const double at_rest = corners != nullptr ? corners->distance_at_rest(gap.element) : info.offset;
    list.push_back({.where = info.name, .clearance = at_rest, .left = 0.0 - gap.largest, .time = gap.time});
  }
  return list;
}

}  // namespace moat
