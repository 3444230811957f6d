// The exact motion of a linear system over one step.
#pragma once

#include <Eigen/Core>

#include "analyses/linear_system.hpp"
#include "analyses/step_task.hpp"
#include "model/model.hpp"

namespace moat {

/// The motion of a linear system over one step. The step is divided into pieces, each at most one step of the system
/// long and within one interval of the motion's samples, so that the ground acceleration is linear in it. The motion
/// goes from piece to piece by the exponential of the system, and inside a piece by the Taylor series from its start,
/// as far as move() was asked for.
class LinearPath {
 public:
  static constexpr Eigen::Index most_pieces = 32;  ///< Of a step.

  /// Begins at this state; `offset` is -M^-1 f0, m/s^2. The system must exist until the next begin() or the end of the
  /// path.
  void begin(const LinearSystem& system, const Vector& offset, const MotionState& start, const StepTask& step);
  /// Moves to the time h s after the start, 0 <= h <= the length of the step: writes it, u, u', u'' and the absolute
  /// jerk -M^-1 (K u' + C u'').
  void move(double h, MotionState& motion);

  [[nodiscard]] Eigen::Index pieces() const { return pieces_; }  ///< Of this step.
  /// Start of a piece; of pieces(): the end of the step. s from the start of the step.
  [[nodiscard]] double start_of(Eigen::Index piece) const { return times_[piece]; }
  /// The ground acceleration there, m/s^2.
  [[nodiscard]] double ground_at(Eigen::Index piece) const { return ground_[piece]; }

 private:
  void go_inside(Eigen::Index piece, double share);

  const LinearSystem* system_ = nullptr;
  double start_time_ = 0.0;  // s
  // At the start of every piece and at the end of the last: time from the start of the step, s; ground acceleration,
  // m/s^2; state of the system, in columns, of which known_ follow the first.
  Vector times_ = Vector::Zero(most_pieces + 1), ground_ = times_;
  Eigen::MatrixXd states_;
  Eigen::Index pieces_ = 0, known_ = 0;
  // The piece of the series. Column k has the coefficients of (t/h)^k in the state, with h the step of the system.
  Eigen::Index expanded_ = most_pieces;
  Eigen::MatrixXd series_;
  Vector inside_;  // the state inside a piece
};

}  // namespace moat
