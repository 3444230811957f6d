// Peaks and clearances as tables of text.
#pragma once

#include <string>
#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

/// The peaks (groups_of_tables()), grouped by quantity in engineering units, each with its unit, its error where that
/// is known ("-53.28 +- 0.02", and "+- numerical error" in the heading), of accelerations the value in g, and the time
/// it was reached. A quantity with more than 12 places has two rows, the largest and the smallest magnitude of its
/// places, which say how many there are. Empty without peaks.
std::string peak_table(const CaseResult& result);

/// The smallest opening of every gap in the same form, with the clearance at rest; of more than 12 gaps that with most
/// and that with least left. Empty without gaps.
std::string clearance_table(const CaseResult& result);

/// The residual displacements of isolators (output/peaks/peak_groups.hpp) in the same form. Empty without isolators.
std::string table_at_the_end(const std::vector<Peak>& isolators);

}  // namespace moat
