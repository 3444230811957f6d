// How far bodies stand apart in drawings that exaggerate displacements.
#pragma once

#include <vector>

#include "base/plan_vector.hpp"
#include "model/model.hpp"

namespace moat {

/// For every node: the vector by which a drawing with displacements f times larger moves its body (f - 1) times, m.
/// A gap is then drawn f times as wide, so that it closes in the drawing when it closes in the model.
///
/// A body is the nodes that elements other than contacts join. The first node of every group of bodies that gaps join
/// stays where it is. Where several gaps lie between two bodies, the smallest counts. On a line y is 0.
std::vector<PlanVector> spread_of_nodes(const Model& model);

}  // namespace moat
