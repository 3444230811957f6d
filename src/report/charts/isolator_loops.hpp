// Charts of force over deformation of isolators.
#pragma once

#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// On a line a chart for each of up to three isolated buildings, with a loop for every isolator. In plan one for the
/// bearing with the largest deformation, with a loop for each component. Isolators without columns for force and
/// deformation are left out. Throws InputError where columns differ in length.
std::vector<Chart> isolator_loops(const CaseResult& result);

}  // namespace moat
