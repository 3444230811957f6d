// A law that carries a building on the ground and lets it move.
#pragma once

#include "elements/link_block.hpp"
#include "elements/link_checks.hpp"
#include "model/model.hpp"

namespace moat {

/// The isolators of a building taken together, with any force-deformation law (materials/response.hpp).
///
///      [ upper ] -> u         law(u_upper - u_lower, v_upper - v_lower)
///     ===law====
///     ////ground///
///
/// If the law has `check(const Check&)`, that is called. Reports `isolator_force` [N] and `isolator_deformation` [m]
/// under its name, positive to the right. Characteristic periods hold the node above it.
template <ForceLaw Law>
struct Isolator {
  std::string name = "bearings";
  NodeId lower = ground;
  /// The floor on it. A ShearBuilding sets it; give it when you add an isolator yourself.
  NodeId upper{};
  Law law;
};

/// The quantities that every isolator reports.
inline ElementInfo isolator_info(const std::string& name, NodeId lower, NodeId upper) {
  return {.name = name,
          .first = lower,
          .second = upper,
          .deformation_quantity = "isolator_deformation",
          .force_quantity = "isolator_force",
          .isolates = true,
          .drawn_as = DrawnAs::bearing};
}

/// Throws InputError for unknown, missing or equal nodes, a name that is taken, or a parameter that the law refuses.
template <ForceLaw Law>
void add(Model& model, const Isolator<Law>& isolator) {
  const Check check =
      check_link(model, "Isolator", isolator.name, {"lower", isolator.lower}, {"upper", isolator.upper});
  if constexpr (requires { isolator.law.check(check); }) isolator.law.check(check);
  model.register_element("Isolator", isolator.name);
  model.block<LinkBlock<Law>>().add(isolator_info(isolator.name, isolator.lower, isolator.upper), isolator.law);
}

}  // namespace moat
