// The sections of the report about the input: origin, motion, model.
#pragma once

#include <string>

#include "output/files/case_result.hpp"

namespace moat::html {

/// Command line, script, version, commit and date.
std::string provenance_section(const Provenance& provenance);
/// All options of the analysis.
std::string analysis_section(const AnalysisFacts& analysis);
/// The motion with its file, scale factor and notes.
std::string motion_section(const MotionFacts& motion);
/// Nodes and elements with their parameters; of a long list the beginning.
std::string model_section(const ModelFacts& model);

}  // namespace moat::html
