// M a + f = -M iota a_g, term by term.
#pragma once

#include "base/plan_vector.hpp"
#include "model/model.hpp"

namespace moat {

/// Calls use(component), where component(i) is the component of a vector of the ground, an acceleration for example,
/// along degree of freedom i. On a line it is the same for all, which saves loops the look at two shares. The model
/// must be prepared.
template <class Use>
void with_ground_component(const Model& model, PlanVector vector, const Use& use) {
  if (model.is_plan())
    use([vector, shares = model.ground_shares()](int i) { return shares.of(vector, i); });
  else
    use([value = vector.x](int) { return value; });
}

/// Sets the accelerations of the trial state to those that balance its forces, after Model::evaluate().
void balance_trial_state(Model& model, PlanVector ground_acceleration);

/// Computes accelerations and jerks of the committed state from its forces, for the start and after events.
void balance_committed_state(Model& model, PlanVector ground_acceleration);

}  // namespace moat
