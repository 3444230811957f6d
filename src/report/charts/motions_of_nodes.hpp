// The histories that move the nodes of a model.
#pragma once

#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

/// The displacement of a node is `factor` times the column; null where the histories do not have it.
struct NodeMotion {
  const Column* column = nullptr;  ///< null: the histories lack it
  double factor = 1.0;             ///< m for a rotation, the gyration; else 1
};

/// One for every node of `result.model`, in its order. The third degree of freedom of a diaphragm is its rotation times
/// its gyration, m.
std::vector<NodeMotion> motions_of_nodes(const CaseResult& result);

}  // namespace moat
