// Response spectra of the motion of floors.
#pragma once

#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// Pseudo-acceleration spectra, with 5 % damping, of the absolute acceleration of base and top of up to three
/// buildings: the demand on equipment and contents that stand there. In plan one chart for each component. After
/// impacts from rows of at most 1 ms (CaseResult::floor_accelerations), else from the histories. Periods from 0.05 s,
/// but at least two intervals of these rows, to 5 s. Left out for less than a hundred rows.
std::vector<Chart> floor_spectra(const CaseResult& result);

}  // namespace moat
