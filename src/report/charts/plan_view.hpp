// The plan of a building with the orbit of its base.
#pragma once

#include <string>
#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

/// A drawing for every base in plan that has an outline, as SVG without prolog: the outline at rest, the walls around
/// it, the orbits of the centre of mass and of all corners, and the impacts with their times. Displacements and
/// clearances are drawn larger than the outline, by a factor that the drawing names; corners then touch walls where
/// they do. Empty for a model on a line and without histories.
std::vector<std::string> plan_views(const CaseResult& result);

}  // namespace moat
