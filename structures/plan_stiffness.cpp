#include "structures/plan_stiffness.hpp"

namespace moat {

Eigen::MatrixXd stiffness_of_floors(const Model& model, const std::vector<DiaphragmId>& floors) {
  std::vector<int> rows;
  for (const DiaphragmId& id : floors)
    for (const NodeId node : id.degrees_of_freedom()) rows.push_back(node.index);
  const Eigen::MatrixXd whole{model.linear_stiffness(StiffnessStage::initial)};
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd stiffness{count, count};
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j)
      stiffness(i, j) = whole(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
  return stiffness;
}

}  // namespace moat
