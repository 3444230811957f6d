// The results of a suite that a design sheet compares with its minima.
#pragma once

#include <string>

#include "design/sheet_inputs.hpp"
#include "study/result.hpp"

namespace moat {

/// The design values of a suite (Suite, RecordStatistics::design_value()) of one building, by bound of its isolators:
/// the largest over eccentricities and directions. Without bounds all are nominal. `base`: the name of its base; drifts
/// and shears are those of all buildings of the models. Throws InputError for a study without records or without a
/// displacement of this base.
SuiteForSheet suite_for_sheet(const StudyResult& study, const std::string& base = "base");

}  // namespace moat
