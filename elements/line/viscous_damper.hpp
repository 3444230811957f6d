// Linear dashpot between two nodes.
#pragma once

#include "model/model.hpp"

namespace moat {

/// A linear dashpot: F = damping * (v_upper - v_lower). Rayleigh damping of a superstructure is made of
/// these: the stiffness part in each storey, the mass part from each floor to the base. Not reported.
struct ViscousDamper {
  std::string name;        ///< Unique in its model.
  Required<NodeId> lower;  ///< The node below, or `ground`.
  Required<NodeId> upper;  ///< The node above.
  /// > 0 N s/m.
  Required<DampingCoefficient> damping;
};

/// Throws InputError for a bad parameter, unknown or equal nodes, or a name that is taken.
void add(Model& model, ViscousDamper damper);

}  // namespace moat
