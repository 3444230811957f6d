// The unknowns of a finite-element model, expressed by the motions of its levels.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "base/sparse_matrix.hpp"
#include "structures/frame/finite_elements.hpp"

namespace moat {

/// Unknowns = of_levels * (motions of the levels) + of_others * (motions to be condensed). Other unknowns are held.
struct Constraints {
  std::vector<Level> levels;  ///< with their heights above the lowest nodes, and the means of their nodes as centres
  int per_level = 3;          ///< motions of a level
  SparseMatrix of_levels;     ///< about these centres
  SparseMatrix of_others;     ///< a one in each column
  std::vector<Eigen::Index> held;  ///< unknowns
  std::vector<std::string> names;  ///< of unknowns: "node 17, rotation about x"
  std::vector<std::string> notes;  ///< sentences for reports
};

/// Throws InputError as condensed() does.
Constraints constraints_of(const FiniteElements& model, const Check& check);

}  // namespace moat
