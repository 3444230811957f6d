// The gaps among the elements of a model.
#pragma once

#include "model/model.hpp"

namespace moat {

/// Whether an element is a gap, whose deformation is its indentation and whose offset is its clearance.
inline bool is_gap(const ElementBlock& block, std::size_t element) {
  return block.info(element).kind == ElementKind::gap;
}

}  // namespace moat
