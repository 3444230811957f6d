// The five-storey building computed by moat.
#pragma once

#include "analyses/transient.hpp"
#include "performance/five_peaks.hpp"

namespace moat::performance {

/// The building in its moat; `locate_yield` as in LeadRubberBearing.
Model five_storey_model(bool locate_yield);

/// Analyses a copy of the model, followed by an observer of the five peaks alone.
Peaks moat_peaks(const Model& model, const GroundMotion& motion, const TransientOptions& options);

/// The same followed by a PeakRecorder, which every run of a script has: all channels of the model.
Peaks moat_peaks_of_all_channels(const Model& model, const GroundMotion& motion, const TransientOptions& options);

}  // namespace moat::performance
