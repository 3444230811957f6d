// Changes of regime at the ends of steps beside located ones, in streets of buildings.
#pragma once

#include <string>

namespace moat {

/// Runs streets of 10, 100 and 1,000 buildings (benchmarks/measuring/street.hpp) with EventTreatment::at_end_of_step
/// and with every touch located at a tight tolerance. Returns the errors of the former as Markdown.
std::string run_streets();

}  // namespace moat
