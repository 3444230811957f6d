// One storey with any law.
#pragma once

#include "elements/block/link_checks.hpp"
#include "model/model.hpp"

namespace moat {

/// One storey with any law of force and deformation (materials/storeys): F(u_upper - u_lower, v_upper - v_lower).
///
/// ShearSpring is the linear one. Reports `drift` [m] and `storey_shear` [N] under its name, and the quantities of its
/// law. If the law has `check(const Check&)`, that is called.
template <ForceLaw Law>
struct Storey {
  std::string name;        ///< Unique in its model.
  Required<NodeId> lower;  ///< The node below, or `ground`.
  Required<NodeId> upper;  ///< The node above.
  Law law;                 ///< Gives the force from the drift.
};

/// Throws InputError for unknown or equal nodes, a name that is taken, or a parameter that the law refuses.
template <ForceLaw Law>
void add(Model& model, const Storey<Law>& storey) {
  add_link(model, "Storey",
           {.name = storey.name,
            .first = storey.lower,
            .second = storey.upper,
            .deformation_quantity = "drift",
            .force_quantity = "storey_shear",
            .drawn_as = DrawnAs::storey},
           storey.law);
}

}  // namespace moat
