// The stiffness of floors in plan.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/model.hpp"

namespace moat {

/// Returns the stiffness of these floors for small motions, all others held: a row and a column for each of their
/// degrees of freedom, N/m.
Eigen::MatrixXd stiffness_of_floors(const Model& model, const std::vector<DiaphragmId>& floors);

}  // namespace moat
