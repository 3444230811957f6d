// Warnings about a finished run, with advice for its kind of steps.
#pragma once

#include <string>
#include <vector>

#include "analyses/time_history/transient.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// In plan: corners in contact that slid past the end of an edge, and rotations whose neglected second-order
/// displacement of a corner, r theta^2/2, exceeds 1 mm or 10 % of the largest indentation.
std::vector<std::string> plan_warnings(const AnalysisState& state, const std::vector<Peak>& peaks,
                                       const std::vector<Impact>& impacts);

/// A storey or an isolator that was deformed by more than 3 m, although not so far that the analysis ended
/// (analyses/events/guards.hpp).
std::vector<std::string> collapse_warnings(const std::vector<Peak>& peaks);

/// High-damping rubber beyond the strain for which its parameters were fitted: a `fitted_strain_share` above 1.
std::vector<std::string> strain_warnings(const std::vector<Peak>& peaks);

/// Walls of moats that were pushed beyond ten times their yield displacement, and soil behind them that resists with
/// more than its `ultimate_force`.
std::vector<std::string> wall_warnings(const Model& model, const std::vector<Peak>& peaks);

/// An energy that is not finite, and an integration error or a residual of the equations above `bound` times the
/// largest input or kinetic energy. Empty if all is well.
std::vector<std::string> energy_warnings(const EnergyBalance& energy, double bound, const TransientOptions& options);

/// That a case is not settled, and why. `impacts`: of the main run.
std::string unsettled_warning(const ErrorBars& bars, std::size_t impacts, const TransientOptions& options);

}  // namespace moat
