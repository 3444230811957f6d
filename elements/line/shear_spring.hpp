// Linear spring between two floors: one storey.
#pragma once

#include "model/model.hpp"

namespace moat {

/// A linear shear spring, usually one storey: F = stiffness * (u_upper - u_lower).
///
///        o upper -> u_upper
///       /
///      / stiffness          drift = u_upper - u_lower, storey shear = F, both positive to the right
///     o lower -> u_lower
///
/// Reports `drift` [m] and `storey_shear` [N] under its name. Damping is an element of its own
/// (ViscousDamper), so that the storey shear is that of the columns.
struct ShearSpring {
  std::string name;        ///< Unique in its model.
  Required<NodeId> lower;  ///< The node below, or `ground`.
  Required<NodeId> upper;  ///< The node above.
  /// > 0 N/m.
  Required<Stiffness> stiffness;
};

/// Throws InputError for a bad parameter, unknown or equal nodes, or a name that is taken.
void add(Model& model, ShearSpring spring);

}  // namespace moat
