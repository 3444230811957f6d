// Where isolators stand when the analysis ends.
#pragma once

#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

/// The deformation of every isolator in the last row of the histories, m, with the time of that row: its residual
/// offset, if the building has come to rest. In plan its length. Empty without histories.
std::vector<Peak> isolators_at_the_end(const Table& histories);

}  // namespace moat
