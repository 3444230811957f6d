// How a time history is computed.
#pragma once

#include "analyses/integrators/integrators.hpp"
#include "analyses/time_history/step_method.hpp"
#include "base/quantity.hpp"
#include "base/units.hpp"
#include "motions/ground_motion.hpp"
#include "output/files/case_result.hpp"
#include "solvers/newton.hpp"

namespace moat {

/// The treatment of a step in which elements change their regime.
enum class EventTreatment {
  /// The step ends at the instant of the first change, located to location_tolerance. This is exact and costs a step
  /// for every change.
  located,
  /// The step is accepted as it is. Every element that is beyond its margin at the end of the step changes its regime
  /// there. The number of steps does not grow with the number of gaps, and accuracy is lost. A touch is found up to a
  /// step too late, when the bodies already overlap, and a contact that begins and ends within one step is missed. The
  /// loss in streets of buildings stands in docs/verification/random_models.md, "Streets".
  at_end_of_step,
};

/// How a time history is computed. Every bound is checked by Transient's constructor.
struct TransientOptions {
  static constexpr double least_tolerance = 1e-12;  ///< Lower bound of `tolerance`.

  /// Newmark, HilberHughesTaylor, GeneralizedAlpha, ExactBetweenEvents or Automatic, with its parameters.
  Integrator integrator = Newmark{};

  /// >= 0 s. Length of a fixed step; 0: the step adapts itself (next three options), which
  /// ExactBetweenEvents requires.
  Time step{};

  /// >= 1e-12, < 1. Adaptive step: the error of acceleration that one step should add at any node, relative to the
  /// scale of the absolute acceleration there (analyses/integrators/acceleration_scales.hpp); above twice that a step
  /// is repeated. Steps are the longest step divided by powers of two. Exact steps: sixteen times this is the error of
  /// the cubic between the ends of a step, relative to the amplitude of the fastest vibration; Newmark's steps between
  /// them, in contact, have a third of it.
  double tolerance = 3e-5;

  /// >= 4. Adaptive step: steps within the duration of one contact, estimated with the masses of the joined nodes
  /// alone. 32 give restitution to 1e-3, 1024 to 1e-6. A fixed step with fewer than 32 warns.
  int steps_per_contact = 32;

  /// >= 0 s. Adaptive step, and exact steps: the longest step. It is the interval of the samples divided by a power of
  /// two, the longest that is at most this; 0: the interval of the samples.
  Time largest_step{};

  /// >= 0, <= 40. Adaptive step: how often the interval of the samples, or largest_step if that is shorter, may be
  /// halved.
  int max_halvings = 24;

  /// >= 0 s. Where the analysis ends; 0: at the last sample of the motion.
  Time end{};

  /// > 0, < 1. Largest out-of-balance force of an accepted step at any node, relative to the largest force there. More,
  /// up to 1e-6, passes where it is round-off of the displacements.
  double force_tolerance = 1e-8;

  /// >= 1. Newton iterations before a step is cut.
  int max_iterations = 20;

  /// The line search of Newton's method. A step that does not converge by full steps is tried with
  /// LineSearch::backtrack before it is cut.
  LineSearch line_search = LineSearch::full_step;

  /// >= 0. How often a step that does not converge is cut in half before the analysis gives up.
  int max_cuts = 12;

  /// > 0 m. A change of regime is located until its margin, a length, is zero to this: the gap at a touch.
  Length location_tolerance = 1e-12 * units::m;

  /// How touches, separations and other changes of regime are treated.
  EventTreatment events = EventTreatment::located;

  /// >= 1. Changes of one element in a window of one second of motion, before the analysis gives up.
  int max_events_per_second = 10000;
};

/// The longest step that an analysis may take, s: the fixed one, or by TransientOptions::largest_step.
double longest_step(const TransientOptions& options, double sample_interval);

/// Returns the part of the options that methods need.
StepSettings settings_of(const TransientOptions& options, const GroundMotion& motion);

/// The options themselves. Throws InputError for one outside its range, and for more than 1e9 steps.
const TransientOptions& checked(const TransientOptions& options, const GroundMotion& motion);

/// Returns all options as they were given, and the numbers of the scheme, for reports.
AnalysisFacts facts_of(const TransientOptions& options);

}  // namespace moat
