#include "analyses/chatter_guard.hpp"

#include <string>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moat {

void ChatterGuard::count(const Model& model, std::span<const RegimeChange> changes) {
  const double time = model.state().time;
  constexpr double window = 1.0;  // s
  if (time - window_start_ > window) {
    window_start_ = time;
    changes_of_.clear();
  }
  for (const RegimeChange& change : changes)
    if (++changes_of_[{change.block, change.element}] > largest_per_second_)
      throw Error{"\"" + model.blocks()[change.block]->info(change.element).name + "\" changed more than " +
                  std::to_string(largest_per_second_) + " times within one second before t = " + to_text(time) +
                  " s: it chatters. Check its stiffness and damping, or raise "
                  "TransientOptions::largest_events_per_second."};
}

}  // namespace moat
