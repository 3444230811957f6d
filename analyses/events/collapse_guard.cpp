#include "analyses/events/collapse_guard.hpp"

#include <cmath>

#include "base/check.hpp"

namespace moat {

void CollapseGuard::look(Model& model) {
  // A deformation is a difference of two displacements, if not one of them.
  if (model.state().displacement.cwiseAbs().maxCoeff() <= 0.5 * largest_deformation) return;
  look_at_elements(model);
}

void CollapseGuard::look_at_elements(const Model& model) {
  for (const auto& block : model.blocks()) {
    if (block->contacts() != nullptr) continue;
    const auto& deformations = block->results().deformations;
    for (std::size_t e = 0; e < block->size(); ++e) {
      if (std::abs(deformations[e]) <= largest_deformation) continue;
      warning_ = "The model collapsed: at t = " + to_text(model.state().time) + " s \"" + block->info(e).name +
                 "\" was deformed by more than " + to_text(largest_deformation) +
                 " m. The analysis ended there. Second-order effects or softening laws left no lateral stiffness, a "
                 "fixed step is too long to be stable, or a parameter has a wrong unit.";
      return;
    }
  }
}

}  // namespace moat
