// The rows of the floors in given matrices.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "structures/superstructure/structure_system.hpp"

namespace moat {

/// Returns the freedoms of the rows of a matrix or of shapes: names in the file go before .freedoms. `floors` as in
/// FreedomOrder::list().
std::vector<Freedom> freedoms_of(const Superstructure& structure, const Check& check, std::string_view field,
                                 const std::vector<std::string>& names, Eigen::Index rows, int floors = 0);

/// Returns the rows of the floors, in the order of the system, in SI: N/m, N and N m, or kg, kg m and kg m^2 where
/// `field` is "mass". Rows of the base follow where the matrix has them and is no mass: rigid motion of all must
/// strain nothing then. Throws InputError where it does, for masses that couple base and floors, for a unit of force
/// that is not given, and for rows that are missing or unknown.
Eigen::MatrixXd floor_matrix(const Superstructure& structure, const Check& check, std::string_view field,
                             const MatrixInUnits& matrix, StructureSystem& system);

}  // namespace moat
