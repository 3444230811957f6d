// The first screen of a report.
#pragma once

#include <string>

#include "output/files/case_result.hpp"

namespace moat::html {

/// Motion and size of the model in one line, then a card for each of the largest displacement, drift, acceleration,
/// isolator deformation and impact force, the smallest clearance left, the number of impacts and the error of the
/// energy balance. Values carry their error bars; those that are not settled are shaded.
std::string summary_section(const CaseResult& result);

/// The verdict of the error bars and all warnings; empty without any.
std::string warning_section(const CaseResult& result);

}  // namespace moat::html
