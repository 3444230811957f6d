// The five-storey building computed by moat.
#pragma once

#include "analyses/transient.hpp"
#include "performance/five_peaks.hpp"

namespace moat::performance {

/// The building in its moat; `locate_yield` as in LeadRubberBearing.
Model five_storey_model(bool locate_yield);

/// Analyses a copy of the model, followed by a PeakRecorder: peaks of all channels of the model.
Peaks moat_peaks(const Model& model, const GroundMotion& motion, const TransientOptions& options);

}  // namespace moat::performance
