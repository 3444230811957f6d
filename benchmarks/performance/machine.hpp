// The machine the figures were measured on.
#pragma once

#include <string>

namespace moat::performance {

/// Processor, number of cores and compiler, in one line.
std::string machine();

}  // namespace moat::performance
