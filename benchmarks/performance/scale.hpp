// How cost grows with size: a street of up to a million degrees of freedom.
#pragma once

#include "performance/options.hpp"
#include "performance/record.hpp"

namespace moat::performance {

/// Time per step and per Newton iteration and memory per degree of freedom from 1e3 to 1e6 degrees of freedom, the
/// parts of an iteration beside the speed of memory.
void scale(Record& record, const Options& options);

}  // namespace moat::performance
