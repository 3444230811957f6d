#include "output/impact_counter.hpp"

namespace moat {

void ImpactCounter::start(const StepView& view) {
  for (std::size_t b = 0; b < view.model.blocks().size(); ++b) {
    const Contacts* contacts = view.model.blocks()[b]->contacts();
    if (contacts == nullptr || contacts->touching() == 0) continue;
    for (std::size_t e = 0; e < view.model.blocks()[b]->size(); ++e)
      if (contacts->contact(e).touching) touching_.emplace(b, e);
  }
  count_ = touching_.size();
}

void ImpactCounter::event(const StepView& view, std::span<const RegimeChange> changes) {
  for (const RegimeChange& gap : changes) {
    const Contacts* contacts = view.model.blocks()[gap.block]->contacts();
    if (contacts == nullptr) continue;
    if (!contacts->contact(gap.element).touching)
      touching_.erase({gap.block, gap.element});
    else if (touching_.emplace(gap.block, gap.element).second)
      ++count_;
  }
}

}  // namespace moat
