// The assumptions of every result of a model.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace moat {

/// Signs, meanings of quantities, and effects that are left out, for models on a line or in plan.
std::vector<std::string> assumptions_of(const Model& model);

}  // namespace moat
