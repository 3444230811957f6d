// An analysis in words, for reports.
#pragma once

#include <string>
#include <vector>

#include "analyses/time_history/step_control.hpp"
#include "analyses/time_history/transient_options.hpp"
#include "model/model.hpp"
#include "motions/ground_motion.hpp"
#include "output/files/analysis_facts.hpp"

namespace moat {

/// Method, step and tolerances, one sentence each. `longest_step` s is that of adapted steps.
std::vector<std::string> assumptions_of(const TransientOptions& options, const StepControl& control,
                                        double longest_step);

/// All options as they were given, and the numbers of the scheme.
AnalysisFacts facts_of(const TransientOptions& options);

/// Settings that can make the results inaccurate, with advice.
std::vector<std::string> warnings_of(const TransientOptions& options, const StepControl& control,
                                     const GroundMotion& motion, const Model& model);

}  // namespace moat
