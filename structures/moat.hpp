// The retaining walls on both sides of an isolated base.
#pragma once

#include "elements/gap.hpp"

namespace moat {

/// A moat: fixed walls on both sides of a node, at the same clearance.
///
///     wall |<- clearance ->[ around ]<- clearance ->| wall
///
/// Two gaps, "<name> left" and "<name> right", whose impact forces share the place <name>.
template <ImpactLaw Law>
struct Moat {
  std::string name = "moat";
  Required<NodeId> around;
  /// > 0 m, on each side at rest.
  Required<Length> clearance;
  Law law;
};

/// Throws InputError as the two gaps would.
template <ImpactLaw Law>
void add(Model& model, const Moat<Law>& moat) {
  model.require_node(moat.around, "Moat \"" + moat.name + "\"", "around");
  add(model, Gap<Law>{.name = moat.name + " left",
                      .place = moat.name,
                      .left = ground,
                      .right = moat.around,
                      .clearance = moat.clearance,
                      .law = moat.law});
  add(model, Gap<Law>{.name = moat.name + " right",
                      .place = moat.name,
                      .left = moat.around,
                      .right = ground,
                      .clearance = moat.clearance,
                      .law = moat.law});
}

}  // namespace moat
