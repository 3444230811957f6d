// Springs and dashpots against the rotation of floors.
#pragma once

#include "elements/block/plan_point.hpp"
#include "model/model.hpp"

namespace moat {

/// A linear spring between the rotations of two floors: M = stiffness * (theta_upper - theta_lower). Not reported.
struct RotationSpring {
  std::string name;  ///< Unique in its model.
  /// A diaphragm or `ground`.
  Required<NodeId> lower;
  Required<NodeId> upper;  ///< The node above.
  /// > 0 N m/rad.
  Required<Energy> stiffness;
};

/// A linear dashpot between them: M = damping * (theta'_upper - theta'_lower). Not reported.
struct RotationDamper {
  std::string name;  ///< Unique in its model.
  /// A diaphragm or `ground`.
  Required<NodeId> lower;
  Required<NodeId> upper;  ///< The node above.
  /// > 0 N m s/rad.
  Required<Quantity<1, 4, -1>> damping;
};

/// Throw InputError for a bad parameter, bodies that do not turn or are the same, or a name that is taken.
void add(Model& model, const RotationSpring& spring);
/// Adds the damper, and throws as for a spring.
void add(Model& model, const RotationDamper& damper);

}  // namespace moat
