// Which loops the compiler turns into vector code.
#pragma once

#include "performance/options.hpp"
#include "performance/record.hpp"

namespace moat::performance {

/// Compiles blocks of elements anew, with the flags users get, and counts the loops that g++ says it has vectorised.
void vector_code(Record& record, const Options& options);

}  // namespace moat::performance
