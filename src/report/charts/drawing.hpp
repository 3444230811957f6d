// The model as a drawing that moves.
#pragma once

#include <string>

#include "output/files/case_result.hpp"

namespace moat::html {

/// The model to scale: the elevation of a model on a line, the plan of one in plan with the orbits of the corners and
/// the centre of mass of every base. The page's script moves it by the histories, with displacements and gaps drawn
/// larger by the same factor, so that bodies touch in the drawing when they touch in the model. Without script it shows
/// the model at rest. Empty without scene (CaseResult::scene) and for less than two rows of histories.
std::string drawing_section(const CaseResult& result);

}  // namespace moat::html
