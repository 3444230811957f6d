// Changes of regime inside the step beside located ones, in streets of buildings.
#pragma once

#include <string>

namespace moat {

/// Runs streets of 10, 100 and 1,000 buildings (benchmarks/measuring/street.hpp) with default options and with every
/// touch located at a tight tolerance. Returns the errors of the defaults as Markdown.
std::string run_streets();

}  // namespace moat
