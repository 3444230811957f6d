// Any force-deformation law between two nodes.
#pragma once

#include "elements/block/link_checks.hpp"
#include "model/model.hpp"

namespace moat {

/// Any force-deformation law (materials/response.hpp) between two nodes: F(u_upper - u_lower, v_upper - v_lower).
///
/// The law may be one of moat's (`Linear`, `Bilinear`, `Viscous`) or a struct of the script's own. If it has
/// `check(const Check&)`, that is called. Reports deformation [m] and force [N] under its name.
template <ForceLaw Law>
struct Spring {
  std::string name;                                  ///< Unique in its model.
  Required<NodeId> lower;                            ///< The node below, or `ground`.
  Required<NodeId> upper;                            ///< The node above.
  Law law;                                           ///< Gives the force from the deformation.
  std::string deformation_quantity = "deformation";  ///< Under which the deformation is reported, m.
  std::string force_quantity = "force";              ///< Under which the force is reported, N.
};

/// Throws InputError for unknown or equal nodes, a name that is taken, or a parameter that the law refuses.
template <ForceLaw Law>
void add(Model& model, const Spring<Law>& spring) {
  add_link(model, "Spring",
           {.name = spring.name,
            .first = spring.lower,
            .second = spring.upper,
            .deformation_quantity = spring.deformation_quantity,
            .force_quantity = spring.force_quantity},
           spring.law);
}

}  // namespace moat
