// The buildings of a model as results list them.
#pragma once

#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

class Model;

/// Names of the parts of every building, by which its peaks are found.
std::vector<BuildingParts> parts_of_buildings(const Model& model);

}  // namespace moat
