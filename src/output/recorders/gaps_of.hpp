// The gaps of a model.
#pragma once

#include "model/model.hpp"

namespace moat {

/// Whether the elements of a block are gaps: their deformation is the indentation, their offset the clearance.
inline bool has_gaps(const ElementBlock& block) { return block.contacts() != nullptr; }

}  // namespace moat
