// Loops of all laws, as pictures of the reference.
#pragma once

#include <string>

namespace moat::testing {

/// Returns an SVG: for every law of AllImpactLaws the force over the indentation in a free impact of 500 t at 1 m/s,
/// with e = 0.65.
std::string impact_law_picture();

/// Returns an SVG: for every law of AllSpringLaws the force over the deformation in three growing cycles at 0.5 Hz,
/// with typical parameters.
std::string spring_law_picture();

}  // namespace moat::testing
