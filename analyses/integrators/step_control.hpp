// How long the next step should be, and by which scheme.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "analyses/integrators/acceleration_scales.hpp"
#include "analyses/integrators/step_scheme.hpp"
#include "analyses/time_history/step_method.hpp"
#include "model/analysis_state.hpp"

namespace moat {

/// Chooses the length of steps: fixed, or by two criteria.
///
/// Outside contact, an error of acceleration. With jerks j at both ends of a step two schemes can be compared, one with
/// the acceleration a parabola through a0, j0 and a1, the other with the cubic through j1 as well. Their difference is
/// the error
///
///     fourth order:          h/12 |2 (a1 - a0)/h - j0 - j1|  =  (w h)^3/72 of a vibration of frequency w
///     average acceleration:  8 h/12 |j1 - j0|                =  8 (w h)^2/12
///
/// divided by the scale of the acceleration of the node (acceleration_scales.hpp); of the translations of a diaphragm
/// the resultants count. The largest of all nodes is compared with the tolerance. The factor 8 is there because (w
/// h)^2/12 is itself the error of period of average acceleration. Where the stiffness of a law without located regimes
/// jumps inside a step, the error of the fourth-order scheme is at least h/12 |j1 - j0|. The force that such a law
/// loses where its path turns inside the step, over the mass, is added (ElementStates::find_corners). A step with more
/// than twice the tolerance is repeated. Differences that are round-off of forces do not count.
///
/// In contact, the duration of the contact divided by steps_per_contact. After four such durations without an event the
/// contact is sustained; from then on the error of acceleration alone sets the step. The first steps after a located
/// touch are shorter, double from one to the next, and are not judged. Up to the first that is not cut to less than a
/// quarter they take average acceleration: some laws' forces rise with infinite slope there (like d^1/4).
///
/// The scheme is that of fourth order where a step is inside its bound of stability. A model that needs more than one
/// halving for the bound of its stiffness takes average acceleration; one that needs more than one for the bound of its
/// damping takes StepScheme::strongly_damped().
///
/// Adaptive steps are the grid interval divided by powers of two, so that they end on samples of the motion and the
/// tangent takes few values.
class StepControl {
 public:
  /// One step to take.
  struct Step {
    double length = 0.0;  ///< s
    StepScheme scheme{};  ///< the numbers of the method
  };

  /// `scheme`: of every step; none: chosen here. The model must be complete.
  StepControl(const AnalysisState& state, const StepSettings& settings, std::optional<StepScheme> scheme);

  /// Whether lengths follow from errors.
  [[nodiscard]] bool adaptive() const { return settings_.fixed_step <= 0.0; }
  /// The step to try next from the committed state.
  [[nodiscard]] Step next_step(const AnalysisState& state);
  /// Judges the trial state that a step of this scheme led to. `filtered_curve`: of a scheme that has it
  /// (StepEquations::filtered_curve). False: repeat with next_step(), which is shorter.
  [[nodiscard]] bool accepts(const AnalysisState& state, const StepTask& step, StepScheme scheme,
                             const double* filtered_curve = nullptr);
  /// The trial state was committed.
  void accepted(const AnalysisState& state, double h, GroundVector ground_acceleration);
  /// Elements changed their regime at the committed state, or the ground stopped; `touched` if a gap closed.
  void restart(const AnalysisState& state, bool touched);

  /// Writes or reads all that changes from step to step.
  void archive(auto& archive) {
    archive(scales_, halvings_, ramp_, planned_, since_event_, fewest_steps_per_contact_, largest_round_off_,
            place_of_round_off_);
  }

  /// Fewest steps any contact was divided into so far; infinite without contact.
  [[nodiscard]] double fewest_steps_per_contact() const { return fewest_steps_per_contact_; }
  /// Bound on the largest squared frequency with open gaps and initial stiffness, 1/s^2.
  [[nodiscard]] double stiffest_squared() const { return stiffest_squared_; }
  /// Largest round-off of a node's acceleration over its scale in adapted steps so far, and where.
  [[nodiscard]] double largest_round_off() const { return largest_round_off_; }
  /// The node of the largest round-off.
  [[nodiscard]] NodeId place_of_round_off() const { return place_of_round_off_; }

 private:
  // After so many halvings of the grid interval, s.
  [[nodiscard]] double step_at(int halvings) const { return steps_[static_cast<std::size_t>(halvings)]; }
  [[nodiscard]] double error_of(const AnalysisState& state, const StepTask& step, StepScheme scheme,
                                const double* filtered_curve);
  void watch_round_off(const AnalysisState& state);

  StepSettings settings_;
  std::optional<StepScheme> scheme_of_all_;
  Resultants resultants_;
  AccelerationScales scales_;
  Vector lost_forces_;
  std::vector<double> steps_;  // the longest, divided by 1, 2, 4, ...; s
  int halvings_ = 0;
  int ramp_ = 0;              // further halvings after a touch
  double planned_ = 0.0;      // s, length of the last next_step(); samples of the motion may cut it
  double since_event_ = 0.0;  // s
  double fewest_steps_per_contact_ = std::numeric_limits<double>::infinity();
  // Bounds on the largest squared frequency, 1/s^2, and rate of damping, 1/s, of the model with open gaps.
  double stiffest_squared_ = 0.0, most_damped_ = 0.0;
  Vector round_off_per_displacement_;  // of every node's acceleration, 1/s^2
  double largest_round_off_ = 0.0;
  NodeId place_of_round_off_{};
};

}  // namespace moat
