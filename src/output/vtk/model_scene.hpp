// Draws a model.
#pragma once

#include "model/model.hpp"
#include "output/vtk/scene.hpp"

namespace moat {

/// The picture of a model: a slab for every node, a panel for every storey and bearing, a line for every gap, a
/// wall where a gap ends at the ground. In plan a prism for every floor, a line for every
/// bearing and contact of a corner, a line for every storey at each corner of its floor, and walls. Elements are
/// numbered through all blocks in their order. Dampers are not drawn.
Scene scene_of(const Model& model);

}  // namespace moat
