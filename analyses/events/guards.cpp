#include "analyses/events/guards.hpp"

#include <algorithm>
#include <cmath>

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

void CollapseGuard::look(const AnalysisState& state) {
  // A deformation is a difference of two displacements, if not one of them.
  if (state.motion().displacement.cwiseAbs().maxCoeff() <= 0.5 * largest_deformation) return;
  for (std::size_t b = 0; b < state.model().blocks().size(); ++b) {
    const ElementBlock& block = *state.model().blocks()[b];
    for (std::size_t e = 0; !block.kind().contacts && e < block.size(); ++e) {
      if (std::abs(state.elements(b).results()[e].deformation) <= largest_deformation) continue;
      warning_ = "The model collapsed: at t = " + to_text(state.time()) + " s \"" + block.info(e).name +
                 "\" was deformed by more than " + to_text(largest_deformation) +
                 " m. The analysis ended there. Second-order effects or softening laws left no lateral stiffness, a "
                 "fixed step is too long to be stable, or a parameter has a wrong unit.";
      return;
    }
  }
}

}  // namespace moat
