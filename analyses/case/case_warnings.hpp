// Warnings about a finished run, with advice for its kind of steps.
#pragma once

#include <string>
#include <vector>

#include "analyses/time_history/transient.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// An acceleration of the ground beyond all records.
std::vector<std::string> motion_warnings(const GroundMotion& motion);

/// Isolators whose strength is above 30 % of the weight on them, so that they hardly ever slide or yield. Gaps whose
/// left side is drawn to the right of their right side; in plan, corners that can jam, and bearings and centres of mass
/// outside the outline of their floor.
std::vector<std::string> model_warnings(const Model& model);

/// First periods of up to eight buildings held at their base that are above 10 s or below 0.02 s: the unit of a
/// stiffness or a mass is another one.
std::vector<std::string> period_warnings(const Model& model);

/// In plan: corners in contact that slid past the end of an edge, and rotations whose neglected second-order
/// displacement of a corner, r theta^2/2, exceeds 1 mm or 10 % of the largest indentation.
std::vector<std::string> plan_warnings(const AnalysisState& state, const std::vector<Peak>& peaks,
                                       const std::vector<Impact>& impacts);

/// A storey or an isolator that was deformed by more than 3 m, although not so far that the analysis ended
/// (analyses/events/guards.hpp).
std::vector<std::string> collapse_warnings(const std::vector<Peak>& peaks);

/// High-damping rubber beyond the strain for which its parameters were fitted: a `fitted_strain_share` above 1.
std::vector<std::string> strain_warnings(const std::vector<Peak>& peaks);

/// An energy that is not finite, and an integration error or a residual of the equations above `bound` times the
/// largest input or kinetic energy. Empty if all is well.
std::vector<std::string> energy_warnings(const EnergyBalance& energy, double bound, const TransientOptions& options);

/// That a case is not settled, and why. `impacts`: of the main run.
std::string unsettled_warning(const ErrorBars& bars, std::size_t impacts, const TransientOptions& options);

}  // namespace moat
