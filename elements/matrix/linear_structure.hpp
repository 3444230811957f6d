// A linear structure of many degrees of freedom, given by its matrices.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace moat {

/// A linear structure on a base, or on the ground:
///
///     v = u - R b        forces on u: f = K v + C v'        forces on b: -R' f
///
/// u are the displacements of `nodes`, b those of `base`; R b is the motion of the nodes with the base where nothing
/// deforms. A degree of freedom of a diaphragm's rotation counts in m, as DiaphragmId has it, so that all entries of
/// K are in N/m and those of C in N s/m. Energies are 1/2 v' K v and the integral of v'' C v'.
struct LinearStructure {
  std::string name;            ///< Unique in its model.
  std::vector<NodeId> nodes;   ///< At least one, all different.
  std::vector<NodeId> base{};  ///< Left out: it stands on the ground.
  Eigen::MatrixXd carried{};   ///< R, 1: a row for each of `nodes`, a column for each of `base`.
  Eigen::MatrixXd stiffness;   ///< K, N/m, symmetric, a row for each of `nodes`.
  Eigen::MatrixXd damping{};   ///< C, N s/m, symmetric; left out: none.
};

/// Throws InputError for an unknown or repeated node, matrices that are not symmetric, not finite or of another size,
/// a stiffness or damping with a negative diagonal, and a name that is taken.
void add(Model& model, const LinearStructure& structure);

}  // namespace moat
