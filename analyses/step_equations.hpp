// The equations of one time step.
#pragma once

#include <cstddef>
#include <vector>

#include "analyses/newmark.hpp"
#include "model/model.hpp"
#include "solvers/factorisation.hpp"
#include "solvers/newton.hpp"

namespace moat {

/// M a + f(u(a), v(a)) = -M iota a_g at the end of a step; the unknown is the acceleration a.
///
/// The acceleration and not the displacement, because a = (u - prediction) / (beta h^2) loses all digits
/// after a very short step, and steps that end at a located event can be very short.
class StepEquations final : public NonlinearSystem {
 public:
  StepEquations(Model& model, NewmarkScheme scheme);

  /// Sets up a step of length h > 0 from the model's committed state, with time and ground acceleration at its end.
  void begin(double h, double end_time, double ground_acceleration);

  /// Accelerations that balance the committed state, for the start and after events: M a = -f - M iota a_g.
  /// Leaves them in the committed state of the model.
  void balance_committed_state(double ground_acceleration);

  int size() const override { return model_->degrees_of_freedom(); }
  bool compute_residual(const Vector& acceleration, Vector& residual) override;
  double residual_scale() const override { return scale_; }
  double round_off() const override;
  bool compute_direction(const Vector& residual, Vector& direction) override;

  [[nodiscard]] long factorisations() const { return factorisation_.count(); }

 private:
  Model* model_;
  NewmarkScheme scheme_;
  Factorisation factorisation_;
  SparseMatrix tangent_;
  double h_ = 0.0;
  double ground_acceleration_ = 0.0;
  Vector predicted_displacement_, predicted_velocity_;
  double scale_ = 0.0;
  // What the factors at hand were made for.
  bool factorised_ = false;
  double factorised_step_ = 0.0;
  long factorised_version_ = 0;
  std::vector<std::size_t> diagonal_;  // positions in the tangent
};

}  // namespace moat
