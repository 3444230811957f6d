// Error bars of peaks, from a second run with finer steps.
#pragma once

#include <functional>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "analyses/case/run_under_way.hpp"
#include "analyses/time_history/transient.hpp"
#include "model/model.hpp"
#include "motions/ground_motion.hpp"
#include "output/files/case_result.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

/// Options of the companion of a run with `options` whose longest step was `longest_step` > 0 s
/// (SolverStatistics::longest_step): everything that has an error is finer. A fixed step is halved. An adapted one has
/// 1/16 of the tolerance, twice the steps per contact, and at most half the longest step; exact steps have the same.
///
/// A coarser companion is not sufficient: where the sampling interval of the motion limits the steps, both runs would
/// take the same steps and show no error.
TransientOptions companion_options(const TransientOptions& options, double longest_step);

/// The companion in one sentence, for reports.
std::string companion_description(const TransientOptions& companion);

/// A large value of every SI unit, in that unit.
using ScalesOfUnits = std::map<std::string, double>;

/// The scales of a run: its largest peaks, and no less than follows from those of other units, so that a quantity that
/// is zero by symmetry or at rest is not judged by its own round-off. Displacements of 1e-12 m (location_tolerance) are
/// none. Accelerations are compared with those of the ground, and of the largest force on the whole mass; rotations
/// times the radius of gyration with displacements, torques with forces times it, and numbers without dimension and
/// temperatures with 1.
ScalesOfUnits scales_of_run(const std::vector<Peak>& peaks, const Model& model, const GroundMotion& motion,
                            const TransientOptions& options);

/// Gives every peak of the main run its error: Richardson's estimate from the companion's peak, whose own error is at
/// most a quarter,
///
///     error = caution * 4/3 |magnitude - magnitude of the companion|
///
/// and at least a share of the differences that are typical of this run, because two runs may also agree by chance, and
/// at least `least_share` >= 0 of the value. A peak that the companion does not have, or that is not finite, has the
/// error NaN. `scales` of units count where they exceed the largest peak.
///
/// Returns the verdict with the companion's impacts and cost. The case is not settled if the numbers of impacts differ,
/// if the speeds of an impact differ by more than 1 % of the fastest approach, or if any error is not within 1 % of its
/// peak. From such an impact on the two runs are two motions, whose peaks may agree by chance. `touches` are those of
/// the main run.
ErrorBars estimate_errors(std::vector<Peak>& peaks, std::span<const Impact> touches, const PeaksAndImpacts& companion,
                          double least_share = 0.0, const ScalesOfUnits& scales = {});

/// Gives every clearance of the main run its error: that of the largest approach of the two sides, estimated like the
/// error of a peak. The errors of the peaks do not change.
void estimate_clearance_errors(PeaksAndImpacts& main, const PeaksAndImpacts& companion, double least_share = 0.0);

/// The least_share of a run. Zero where all changes of stiffness are located. The stiffness of other laws (a bearing in
/// plan, a law of the script) may change inside a step, and both runs may step over the same change.
/// The bars of an adapted run are then at least this share of the peak, in proportion to the tolerance.
double least_share_of_errors(const Model& model, const TransientOptions& options);

/// Whether a run of this model that takes `solves` steps or Newton iterations, whichever are more, evaluates few enough
/// elements for a companion by default: 2e5.
bool companion_is_cheap(const Model& model, double solves);

}  // namespace moat
