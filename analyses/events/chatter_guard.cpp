#include "analyses/events/chatter_guard.hpp"

#include <algorithm>
#include <string>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moat {

void ChatterGuard::count(const AnalysisState& state, std::span<const RegimeChange> changes) {
  const double time = state.motion().time;
  constexpr double window = 1.0;  // s
  if (time - window_start_ > window) {
    window_start_ = time;
    for (std::vector<int>& of_block : changes_of_) std::ranges::fill(of_block, 0);
  }
  changes_of_.resize(state.model().blocks().size());
  for (const RegimeChange& change : changes) {
    std::vector<int>& of_block = changes_of_[change.block];
    of_block.resize(state.model().blocks()[change.block]->size(), 0);
    if (++of_block[change.element] > largest_per_second_)
      throw Error{"\"" + state.model().blocks()[change.block]->info(change.element).name + "\" changed more than " +
                  std::to_string(largest_per_second_) + " times within one second before t = " + to_text(time) +
                  " s: it chatters. Check its stiffness and damping, or raise "
                  "TransientOptions::max_events_per_second."};
  }
}

}  // namespace moat
