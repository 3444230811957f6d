// The stiffness of a member of a frame.
#pragma once

#include <Eigen/Core>

#include "base/check.hpp"
#include "structures/frame/frame.hpp"

namespace moat {

/// A member between two places.
struct PlacedMember {
  /// It acts on the motions x, y, z and rotations about x, y, z of both nodes, along the axes of the building: N/m, N,
  /// N m.
  Eigen::Matrix<double, 12, 12> stiffness;
  double length = 0.0;  ///< m, of the flexible part
};

/// Throws InputError for a bad parameter of the member; `name` stands in the messages.
PlacedMember place_member(const FrameMember& member, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                          const std::string& name, const Check& check);

}  // namespace moat
