#include "analyses/time_history/equation_of_motion.hpp"

namespace moat {

void balance_trial_state(Model& model, PlanVector ground_acceleration) {
  const Vector& force = model.internal_forces();
  const GroundShares shares = model.ground_shares();
  Vector& acceleration = model.trial().acceleration;
  for (int i = 0; i < model.degrees_of_freedom(); ++i)
    acceleration[i] = -force[i] / model.masses()[i] - shares.of(ground_acceleration, i);
}

void balance_committed_state(Model& model, PlanVector ground_acceleration) {
  model.trial() = model.state();
  model.evaluate();
  balance_trial_state(model, ground_acceleration);
  model.evaluate_rates();
  model.commit();
}

}  // namespace moat
