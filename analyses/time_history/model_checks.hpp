// Mistakes in a model that an analysis would not survive, or would hide.
#pragma once

#include "model/analysis_state.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// Throws InputError for bodies that nothing holds: no path of elements other than gaps leads from them to the ground,
/// or in plan they can move without deforming an element. Stiffness does not count, so that a dashpot holds like a
/// spring. Bodies that are free (Node::free) or that move are left out.
void check_held(const AnalysisState& state);

/// Throws InputError for two gaps between the same two buildings, or the same two nodes of no building, one of which
/// has the first on the left and the other on the right. A body whose half width fits into that of the other, where
/// their x puts it, may have gaps on both sides.
void check_gap_directions(const Model& model);

/// Throws InputError for a motion of two components on a line. It throws too for a state that is not of this model as
/// it is now, stands at or beyond `end` s, or came to its time under other accelerations of the ground.
void check_start(const Model& model, const AnalysisState& state, const GroundMotion& motion, double end);

}  // namespace moat
