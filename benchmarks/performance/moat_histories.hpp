// Histories of the five-storey building by moat.
#pragma once

#include "analyses/case/case_run.hpp"
#include "measuring/five_peaks.hpp"

namespace moat::performance {

/// Analyses the model, followed by an observer of the five peaks alone, like those of other programs.
Peaks moat_peaks(const Model& model, const GroundMotion& motion, const TransientOptions& options);

/// Runs a case as a script does, up to its results in memory: CaseRun with peaks, energy ledger, impacts, histories,
/// periods and, as options, the second run for error bars and the runs with changed contacts.
Peaks moat_case(const Model& model, const GroundMotion& motion, const TransientOptions& options,
                ErrorBarMode error_bars, ContactSensitivityMode sensitivity = ContactSensitivityMode::never);

}  // namespace moat::performance
