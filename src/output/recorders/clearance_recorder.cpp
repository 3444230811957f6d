#include "output/recorders/clearance_recorder.hpp"

#include <limits>

#include "base/hermite.hpp"

namespace moat {

ClearanceRecorder::ClearanceRecorder(const Model& model) : model_{&model} {
  constexpr double none = -std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    if (!model.blocks()[b]->kind().contacts) continue;
    for (std::size_t e = 0; e < model.blocks()[b]->size(); ++e) gaps_.push_back({b, e, none, 0.0, none, 0.0});
  }
}

void ClearanceRecorder::step(const StepView& view) {
  const double time = view.state.time(), step = time - time_before_;
  for (Gap& gap : gaps_) {
    const ContactView contact = view.state.elements(gap.block).contact(gap.element);
    const double indentation = -contact.distance, rate = -contact.distance_rate;
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
    const ElementInfo& info = model_->blocks()[gap.block]->info(gap.element);
    const double at_rest = info.corner_pair() != nullptr ? info.corner_pair()->distance_at_rest : info.offset;
    list.push_back({.where = info.name, .clearance = at_rest, .left = 0.0 - gap.largest, .time = gap.time});
  }
  return list;
}

}  // namespace moat
