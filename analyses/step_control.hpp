// How long the next step should be.
#pragma once

#include <limits>
#include <vector>

#include "base/vector.hpp"
#include "model/model.hpp"

namespace moat {

/// Chooses steps: fixed, or so that two things are resolved.
///
/// Outside contact, the acceleration. Newmark's error is one of period: a vibration of frequency w loses
/// (w h)^2 / 12 of its phase, which an estimate on displacements does not see until accelerations are wrong. The
/// second difference of the absolute accelerations is (w h)^2 times their amplitude, so
///
///     error = max |h^2 d2a/dt2| / 12 / (largest absolute acceleration so far)
///
/// is that loss, weighted with what it matters for the peaks. A step with four times the tolerance is repeated.
///
/// In contact, the contact's own duration, divided into steps_per_contact. A contact that lasts longer than four
/// times that is a body leaning on another, and its accelerations tell enough.
///
/// The first steps, at the start and after every event, are shorter and double from one to the next: nothing is known
/// yet of what they must resolve, and some laws' forces rise with infinite slope at touch (like d^1/4), where the
/// first full step alone would cost 0.4 % of the peak acceleration.
///
/// Adaptive steps are the grid interval divided by powers of two, so that they end on the samples of the motion and
/// the tangent takes few values.
class StepControl {
 public:
  struct Options {
    double fixed_step = 0.0;     ///< s; 0: adaptive
    double grid_interval = 0.0;  ///< s; the largest adaptive step
    double tolerance = 1.2e-4;
    int steps_per_contact = 32;
    int largest_halvings = 24;
  };

  StepControl() = default;
  StepControl(const Model& model, Options options);

  [[nodiscard]] bool adaptive() const { return options_.fixed_step <= 0.0; }
  /// The step to try next from the committed state, s.
  [[nodiscard]] double next_step(const Model& model);
  /// Judges the trial state, h seconds after the committed one. False: repeat with next_step(), which is shorter.
  [[nodiscard]] bool accepts(const Model& model, double h, double ground_acceleration);
  /// The trial state was committed.
  void accepted(const Model& model, double h, double ground_acceleration);
  /// A step that was not chosen here was committed.
  void passed(const Model& model, double ground_acceleration);
  /// Forces jumped or bent: what came before is no measure of what follows.
  void restart(const Model& model, double ground_acceleration);

  /// Fewest steps any contact was divided into so far; infinite without contact.
  [[nodiscard]] double fewest_steps_per_contact() const { return fewest_steps_per_contact_; }

 private:
  [[nodiscard]] double step_at(int halvings) const { return steps_[static_cast<std::size_t>(halvings)]; }
  void remember(const Model& model, double h, double ground_acceleration);

  Options options_;
  std::vector<double> steps_;  // grid interval divided by 1, 2, 4, ...; s
  int halvings_ = 0;
  int ramp_ = 0;              // further halvings after an event
  double since_event_ = 0.0;  // s
  // The last two committed absolute accelerations of this smooth stretch, and the step between them.
  Vector before_, last_;
  double last_h_ = 0.0;
  int known_ = 0;
  double largest_acceleration_ = 0.0;
  double fewest_steps_per_contact_ = std::numeric_limits<double>::infinity();
};

}  // namespace moat
