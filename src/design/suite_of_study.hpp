// The results of a suite that a design sheet compares with its minima.
#pragma once

#include <string>

#include "design/sheet_inputs.hpp"
#include "motions/spectra/scale_suite.hpp"
#include "study/result.hpp"

namespace moat {

/// The design values of a suite (Suite, RecordStatistics::design) of one building, by bound of its isolators:
/// the largest over eccentricities and directions. Without bounds all are nominal.
///
/// base: the name of its base; displacements, shears and the first storey are taken from its building, drifts from all
/// buildings of the models. Shears are compared with minima: in plan each is the smaller of x and y. The base shear is
/// `total_isolator_force` where the study has it, else `total_base_shear`, which has the forces of impacts too.
///
/// Throws InputError for a study without records, without a displacement of this base, or with a combination of bound,
/// eccentricity and direction that no record has a result of.
SuiteForSheet suite_for_sheet(const StudyResult& study, const std::string& base = "base");
/// With the rule of scaling, which the sheet notes.
SuiteForSheet suite_for_sheet(const StudyResult& study, const ScaledSuite& scaled, const std::string& base = "base");

}  // namespace moat
