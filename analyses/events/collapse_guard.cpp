#include "analyses/events/collapse_guard.hpp"

#include <cmath>

#include "base/check.hpp"

namespace moat {

void CollapseGuard::look(AnalysisState& state) {
  // A deformation is a difference of two displacements, if not one of them.
  if (state.motion().displacement.cwiseAbs().maxCoeff() <= 0.5 * largest_deformation) return;
  look_at_elements(state);
}

void CollapseGuard::look_at_elements(const AnalysisState& state) {
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
