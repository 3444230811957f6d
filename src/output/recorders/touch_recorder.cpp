#include "output/recorders/touch_recorder.hpp"

namespace moat {

void TouchRecorder::start(const StepView& view) {
  for (std::size_t b = 0; b < view.model.blocks().size(); ++b) {
    const Contacts* contacts = view.model.blocks()[b]->contacts();
    if (contacts == nullptr || contacts->touching() == 0) continue;
    for (std::size_t e = 0; e < view.model.blocks()[b]->size(); ++e)
      if (contacts->contact(e).touching) add(view, b, e, view.model.state().time);
  }
}

void TouchRecorder::event(const StepView& view, std::span<const RegimeChange> changes) {
  for (const RegimeChange& gap : changes) {
    const Contacts* contacts = view.model.blocks()[gap.block]->contacts();
    if (contacts == nullptr) continue;
    if (contacts->contact(gap.element).touching)
      add(view, gap.block, gap.element, gap.time);
    else
      touching_.erase({gap.block, gap.element});
  }
}

void TouchRecorder::add(const StepView& view, std::size_t block, std::size_t element, double time) {
  if (!touching_.emplace(block, element).second) return;
  const ElementBlock& gaps = *view.model.blocks()[block];
  touches_.push_back({gaps.info(element).name, time, gaps.contacts()->contact(element).approach_speed});
}

}  // namespace moat
