// Warnings about a finished run, with advice for its kind of steps.
#pragma once

#include <string>
#include <vector>

#include "analyses/transient.hpp"
#include "output/case_result.hpp"

namespace moat {

/// An acceleration of the ground beyond all records.
std::vector<std::string> motion_warnings(const GroundMotion& motion);

/// Gaps whose left side is drawn to the right of their right side.
std::vector<std::string> model_warnings(const Model& model);

/// An energy that is not finite, and an integration error or a residual of the equations above `bound` times the
/// largest input or kinetic energy. Empty if all is well.
std::vector<std::string> energy_warnings(const EnergyBalance& energy, double bound, const TransientOptions& options);

/// That a case is sensitive, and why. `impacts`: of the main run.
std::string sensitivity_warning(const ErrorBars& bars, std::size_t impacts, const TransientOptions& options);

}  // namespace moat
