// Work for equal accuracy: one building, many ways to compute it.
#pragma once

#include "performance/options.hpp"
#include "performance/record.hpp"

namespace moat::performance {

/// Error of five peaks against CPU time for moat, general integrators of differential equations and bare loops.
void equal_accuracy(Record& record, const Options& options);

}  // namespace moat::performance
