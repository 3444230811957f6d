// A study: the same building again and again.
#pragma once

#include "performance/options.hpp"
#include "performance/record.hpp"

namespace moat::performance {

/// Histories per second of the study of 41 gaps under four motions, and what a second thread brings.
void suite(Record& record, const Options& options);

}  // namespace moat::performance
