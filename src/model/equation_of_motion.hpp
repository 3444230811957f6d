// M a + f = -M iota a_g, term by term.
#pragma once

#include "base/ground_vector.hpp"
#include "model/analysis_state.hpp"

namespace moat {

/// Calls use(component), where component(i) is the displacement of degree of freedom i when the ground moves by a
/// vector and nothing deforms, iota u_g; of accelerations for example. Where all degrees of freedom move along x it is
/// the same for all, which saves loops the look at three shares.
template <class Use>
void with_ground_component(const Model& model, GroundVector vector, const Use& use) {
  if (model.moves_along_x())
    use([value = vector.x](int) { return value; });
  else
    use([vector, influence = model.ground_influence()](int i) { return influence.times(vector, i); });
}

/// Calls use(force), where force(i) is the force on degree of freedom i for an acceleration of the ground, M iota a_g.
template <class Use>
void with_ground_inertia(const AnalysisState& state, GroundVector acceleration, const Use& use) {
  if (state.model().moves_along_x())
    use([value = acceleration.x, inertia = state.ground_inertia().x](int i) { return inertia[i] * value; });
  else
    use([acceleration, inertia = state.ground_inertia()](int i) { return inertia.times(acceleration, i); });
}

}  // namespace moat
