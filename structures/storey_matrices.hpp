// Stiffness and mass of a building from its storeys.
#pragma once

#include "structures/files/storey_table.hpp"
#include "structures/frame/finite_elements.hpp"

namespace moat {

/// The matrices of a building whose storeys are springs between neighbouring floors, in plan, with the base held; its
/// mass is diagonal. Every storey has three springs at its centre of rigidity C, between floor i and the floor below,
/// whose centres of mass are m_i and m_(i-1):
///
///     K += B' diag(kx, ky, kt) B        B = P(C, m_i) on floor i, -P(C, m_(i-1)) on the floor below
///
///     P(C, m) = [ 1  0  -(y_C - y_m) ]
///               [ 0  1    x_C - x_m  ]
///               [ 0  0        1      ]
///
/// Throws InputError for storeys without a floor, and a stiffness, mass or rotary inertia that is not > 0.
CondensedStructure storey_matrices(const StoreyTable& storeys);

}  // namespace moat
