// Shears, moments and drifts of the storeys of a superstructure.
#pragma once

#include <string>
#include <vector>

#include "model/building.hpp"
#include "structures/superstructure/structure_system.hpp"

namespace moat {

/// The degrees of freedom of a superstructure: those of its floors, or the coordinates of its modes, and its base.
struct StructureRows {
  std::vector<NodeId> own, base;  ///< base: empty on the ground
};

/// Results of every storey i of a tower, below floor i, of the elastic forces f = K (u - R b), or M Phi M_q^-1 K_q q of
/// modes, on the floors j >= i and on motions that are kept there:
///
///     shear V = sum f_j        overturning moment M = sum f_j (z_j - z_(i-1))
///     torque T = sum [f_theta,j + (x_j - x_o) f_y,j - (y_j - y_o) f_x,j]
///
/// that is, the work of f in rigid motions about the storey's foot. Towers on these floors count among them.
/// Moments are named by the direction of their forces. (x_o, y_o) is the centre of mass of the base, or of the lowest
/// floor of a building on the ground. On a line the drift, the displacement relative to the floor below, is a result
/// too; in plan every building has it.
std::vector<StoreyResult> storey_results(const StructureSystem& system, const StructureRows& rows,
                                         const std::string& tower, const std::string& prefix);

}  // namespace moat
