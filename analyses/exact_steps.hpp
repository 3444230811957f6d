// Exact steps of a model that is linear between events.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "analyses/linear_path.hpp"
#include "analyses/linear_system.hpp"
#include "analyses/step_control.hpp"
#include "analyses/stepper.hpp"
#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"
#include "model/model.hpp"

namespace moat {

/// Between touches, yields and unloadings a building of linear storeys, dashpots and located bilinear bearings is a
/// linear system under a ground acceleration that is linear between samples:
///
///     u'' = -M^-1 (K u + C u' + f0) - iota (a_g + s t)
///
/// with the tangents K and C of the current regimes and f0, the elements' forces at zero displacement and velocity.
/// Its motion from one time to the next is exact to round-off (analyses/linear_system.hpp): there is no error of
/// period.
///
/// A step consists of pieces (analyses/linear_path.hpp), as many as a power of two, at most 32. A piece is the
/// interval of the samples (or less, by largest_step), halved until the fastest eigenvalue of the system times the
/// piece is at most 1/2, and so small that the cubic over one piece meets a vibration of this frequency to the
/// tolerance below. Elements, changes of regime and peaks are looked at from end to end of a step, by the
/// cubic through values and rates. A step of several pieces is accepted only if this cubic meets the exact motion of
/// every node at the end of every part, to `cubics_within` tolerances: its absolute acceleration, of the scale of that
/// place (analyses/acceleration_scales.hpp), and its velocity, of its largest so far, but at least of 1e-6 of that of
/// the fastest node: less may be round-off. (A stiff wall follows the ground: its acceleration is smooth, its velocity
/// hardly.) Unlike errors of implicit steps this one does not accumulate. Steps double where the cubic over the last
/// two steps would be so good.
///
/// While a gap is closed the model is not linear and applies() is false; Transient takes Newmark's steps there, with
/// `share_in_contact` of the tolerance.
class ExactSteps final : public Stepper {
 public:
  /// Matrices are full: this is for small models.
  static constexpr int most_degrees_of_freedom = 50;
  static constexpr double cubics_within = 16.0;  ///< Tolerances by which the cubic of a step may miss the motion.
  /// Of the tolerance, that Newmark's steps in contact may use: their errors are all that accumulates, and they are
  /// few.
  static constexpr double share_in_contact = 1.0 / 3.0;

  /// The model must be prepared. All must outlive this object; `control` has the longest steps, the tolerance and the
  /// scales of accelerations, and chooses the steps in contact. Throws InputError for a model with too many degrees of
  /// freedom, an element that is not linear between events, or an eigenvalue that needs thousands of pieces from sample
  /// to sample.
  ExactSteps(Model& model, StepControl& control);

  /// Whether the model is linear now: no gap is closed.
  [[nodiscard]] bool applies() const { return !touching_; }
  /// Elements changed their regime, or the model its state: the linear system must be made again.
  void restart();

  double next_length() override;
  void begin(const StepTask& step) override;
  bool solve(const StepTask& part) override;
  bool look(const StepTask& part) override;
  void complete() override;
  bool accepts(const StepTask& step, std::span<const RegimeChange>) override;
  bool may_leave_samples() const override { return control_->may_leave_samples(); }
  WorkRule work_rule() const override { return WorkRule::quadrature; }

 private:
  // The start of the last accepted step.
  struct Earlier {
    double length = 0.0;  // of that step, s; 0: none
    double ground_acceleration = 0.0;
    MotionState motion;
  };

  struct MotionOnGround {
    const MotionState* motion;
    double ground;  // acceleration, m/s^2
  };

  void check() const;
  void linearise();
  void move_to_end(const StepTask& part);
  [[nodiscard]] bool meets(const MotionOnGround& from, const MotionOnGround& to, double h, double time,
                           const double* motion, double ground_there, double allowed);
  [[nodiscard]] bool interpolates(const StepTask& step);
  [[nodiscard]] bool would_interpolate_doubled(const StepTask& step);

  Model* model_;
  StepControl* control_;
  bool touching_ = false;
  bool linearised_ = false;
  std::vector<LinearSystem> systems_;
  std::size_t current_ = 0;
  SparseMatrix stiffness_, damping_;
  Vector forces_at_rest_, offset_;  // f0, -M^-1 f0
  double wanted_ = 0.0;             // length of the next step, if the system allows it; s
  Earlier earlier_;
  Vector fastest_;               // largest velocity of every node so far, m/s; as long as those of a MotionState
  double least_velocity_ = 0.0;  // of the scales, m/s
  LinearPath path_;
};

}  // namespace moat
