// The five-storey building computed by moat.
#pragma once

#include "analyses/case_run.hpp"
#include "measuring/five_peaks.hpp"

namespace moat::performance {

/// The building in its moat.
Model five_storey_model();

/// Analyses a copy of the model, followed by an observer of the five peaks alone: the work of the loops written by
/// hand.
Peaks moat_peaks(const Model& model, const GroundMotion& motion, const TransientOptions& options);

/// The same as a script does it, up to its results in memory: CaseRun with peaks, energy ledger, impacts, histories,
/// periods and, as an option, the second run for error bars.
Peaks moat_case(const Model& model, const GroundMotion& motion, const TransientOptions& options,
                ErrorBarMode error_bars = ErrorBarMode::never);

/// The observers of moat_peaks(), or those of moat_case() without error bars.
enum class Recorded { five_peaks, everything };

/// The number of steps of such an analysis.
long moat_steps(const Model& model, const GroundMotion& motion, const TransientOptions& options, Recorded recorded);

}  // namespace moat::performance
