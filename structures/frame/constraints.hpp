// The unknowns of a finite-element model, expressed by the motions of its levels.
#pragma once

#include <Eigen/Core>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/check.hpp"
#include "base/sparse_matrix.hpp"
#include "structures/frame/finite_elements.hpp"

namespace moat {

/// Nodes by their names. They must outlive it.
class NodeNumbers {
 public:
  /// Throws InputError for a name that is given twice, and a coordinate that is not finite.
  NodeNumbers(const std::vector<FrameNode>& nodes, const Check& check);
  /// Throws InputError for an unknown node; `whose`: "member 7: ", or empty.
  [[nodiscard]] std::size_t of(const NodeName& name, const std::string& whose = {}) const;
  [[nodiscard]] std::string name(std::size_t node) const;  ///< The name of the node, or its number from 1.
  /// "node 17, rotation about x" of motion 6 i + d.
  [[nodiscard]] std::string motion_name(Eigen::Index motion) const;

 private:
  const std::vector<FrameNode>& nodes_;
  const Check& check_;
  std::unordered_map<std::string, std::size_t> numbers_;
};

/// Unknowns = of_levels * (motions of the levels) + others. The rest is held.
struct Constraints {
  std::vector<Level> levels;  ///< with their heights above the lowest nodes, and the means of their nodes as centres
  int per_level = 3;          ///< motions of a level
  double lowest = 0.0;        ///< m, of the nodes
  SparseMatrix equations;     ///< motions of the nodes = equations * unknowns
  SparseMatrix of_levels;     ///< about these centres
  std::vector<Eigen::Index> others, held;  ///< unknowns
  std::vector<Eigen::Index> motions;       ///< the first one of each unknown
  std::vector<int> level_of_node;          ///< -1: none
  std::vector<std::string> notes;          ///< sentences for reports
};

/// Throws InputError as condensed() does.
Constraints constraints_of(const FiniteElements& model, const NodeNumbers& nodes, const Check& check);

/// The index of the level on which a level stands: the last one before it in its tower, or else without tower; -1:
/// none.
template <class Levels>
int level_below(const Levels& levels, std::size_t level) {
  for (const std::string& tower : {levels[level].tower, std::string{}})
    for (std::size_t i = level; i-- > 0;)
      if (levels[i].tower == tower) return static_cast<int>(i);
  return -1;
}

}  // namespace moat
