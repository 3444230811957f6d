// Matrices in the format of Matrix Market.
#pragma once

#include <Eigen/Core>

#include "base/text/rows.hpp"

namespace moat {

/// Whether the text begins with %%MatrixMarket.
bool is_matrix_market(const TextFile& file);

/// `%%MatrixMarket matrix coordinate|array real|integer general|symmetric`, then `rows columns entries` and lines
/// `row column value`, counted from 1; as an array `rows columns` and one value in a line, column by column. A
/// symmetric matrix has one triangle.
///
/// Returns the matrix. Throws FileError naming file, line and mistake: another banner, a matrix that is not square,
/// a wrong count of entries, an entry that is given twice, in one triangle or in both of a symmetric matrix.
///
/// Source: Boisvert, Pozo & Remington (1996), The Matrix Market exchange formats: initial design, NISTIR 5935.
Eigen::MatrixXd matrix_market_of(const Rows& rows);

}  // namespace moat
