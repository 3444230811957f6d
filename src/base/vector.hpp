// The global vector type.
#pragma once

#include <Eigen/Core>

namespace moat {

/// One entry per degree of freedom, SI.
using Vector = Eigen::VectorXd;

}  // namespace moat
