// The global sparse matrix type.
#pragma once

#include <Eigen/SparseCore>

namespace moat {

/// Compressed columns, one row and one column per degree of freedom, SI.
using SparseMatrix = Eigen::SparseMatrix<double>;

}  // namespace moat
