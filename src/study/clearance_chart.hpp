// How much clearance the cases of a study leave.
#pragma once

#include <optional>

#include "output/charts/chart.hpp"
#include "study/result.hpp"

namespace moat {

/// "Clearance left": the share of the cases whose smallest clearance left of all gaps is not above a value, in cm;
/// below zero they touch. A curve for each value of the axis "bounds", or one for all cases; each rises by 1/n at each
/// of its n solved cases. Cases without result do not count, and the legend names them; a case
/// that collapsed counts with the clearance that it had left until then.
///
/// None for a study without gaps, without an axis of at least two records, and where an axis other than "direction" has
/// numbers: its cases are no sample.
std::optional<Chart> clearance_chart(const StudyResult& study);

}  // namespace moat
