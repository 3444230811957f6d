#include "elements/matrix/linear_structure.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/check.hpp"
#include "elements/matrix/linear_structure_block.hpp"

namespace moat {
namespace {

void check_matrix(const Check& check, std::string_view field, const Eigen::MatrixXd& matrix, Eigen::Index size) {
  check.that(
      matrix.rows() == size && matrix.cols() == size && matrix.allFinite() && matrix == matrix.transpose() &&
          matrix.diagonal().minCoeff() >= 0.0,
      std::string{field} + " is not a symmetric matrix of finite numbers with a diagonal >= 0 and one row per node.",
      "Give as many rows as nodes, in N/m or N s/m.");
}

std::vector<int> indices_of(const std::vector<NodeId>& nodes) {
  std::vector<int> indices;
  for (const NodeId node : nodes) indices.push_back(node.index);
  return indices;
}

// [A, -A R; -R' A, R' A R] of the matrix A of the nodes.
Eigen::MatrixXd with_base(const Eigen::MatrixXd& own, const Eigen::MatrixXd& carried) {
  const Eigen::Index n = own.rows(), m = carried.cols();
  Eigen::MatrixXd all{n + m, n + m};
  const Eigen::MatrixXd coupled = own * carried;
  all << own, -coupled, -coupled.transpose(), carried.transpose() * coupled;
  return all;
}

}  // namespace

void add(Model& model, const LinearStructure& structure) {
  const Check check{"LinearStructure", structure.name};
  check.that(!structure.nodes.empty(), "no nodes are given.", "Give .nodes, one for each row of the stiffness.");
  std::vector<NodeId> joined = structure.nodes;
  joined.insert(joined.end(), structure.base.begin(), structure.base.end());
  for (const NodeId node : joined) {
    model.require_node(node, check, "a node");
    check.that(node != ground && !node.is_follower() && std::ranges::count(joined, node) == 1,
               "a node is the ground, repeated, or has no degree of freedom of its own.",
               "Give different nodes with mass.");
  }
  const auto n = static_cast<Eigen::Index>(structure.nodes.size()),
             m = static_cast<Eigen::Index>(structure.base.size());
  check_matrix(check, "stiffness", structure.stiffness, n);
  const bool has_damping = structure.damping.size() > 0;
  if (has_damping) check_matrix(check, "damping", structure.damping, n);
  check.that(
      m == 0 || (structure.carried.rows() == n && structure.carried.cols() == m && structure.carried.allFinite()),
      "carried is not a matrix of finite numbers with one row per node and one column per node of the base.",
      "Give the displacement of every node when the base moves by 1.");
  StructureMatrices matrices{.nodes = indices_of(structure.nodes),
                             .base = indices_of(structure.base),
                             .carried = m > 0 ? structure.carried : Eigen::MatrixXd(n, 0),
                             .stiffness = structure.stiffness,
                             .damping = has_damping ? structure.damping : Eigen::MatrixXd::Zero(n, n),
                             .all = indices_of(joined),
                             .largest_stiffness = structure.stiffness.diagonal().maxCoeff()};
  check.positive("largest stiffness", matrices.largest_stiffness, "N/m");
  matrices.all_stiffness = with_base(matrices.stiffness, matrices.carried);
  matrices.all_damping = with_base(matrices.damping, matrices.carried);
  model.register_element("LinearStructure", structure.name);
  const NodeId first = m > 0 ? structure.base.front() : ground;
  model.block<LinearStructureBlock>().add(
      {.name = structure.name,
       .first = first,
       .second = structure.nodes.front(),
       .drawn_as = DrawnAs::nothing,
       .details = std::make_shared<const ElementDetails>(ElementDetails{.joined = std::move(joined)})},
      std::move(matrices));
}

}  // namespace moat
