// All linear structures of a model.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "elements/matrix/linear_structure.hpp"
#include "model/element_block.hpp"

namespace moat {

/// The matrices of a linear structure, with a row for each of its nodes and bases together.
struct StructureMatrices {
  std::vector<int> nodes{}, base{};                   ///< indices of degrees of freedom
  Eigen::MatrixXd carried{}, stiffness{}, damping{};  ///< R, K and C
  std::vector<int> all{};                             ///< nodes, then base
  Eigen::MatrixXd all_stiffness{}, all_damping{};     ///< of all: [K, -K R; -R' K, R' K R]
  double largest_stiffness = 0.0;                     ///< on the diagonal of K, N/m
};

/// Holds linear structures; their states are LinearStructureStates.
class LinearStructureBlock final : public ElementBlock {
 public:
  /// Appends one that was checked.
  void add(ElementInfo info, StructureMatrices matrices);

  /// In the order in which they were added.
  [[nodiscard]] const std::vector<StructureMatrices>& matrices() const { return matrices_; }

  std::unique_ptr<ElementBlock> clone() const override { return std::make_unique<LinearStructureBlock>(*this); }
  const std::deque<ElementInfo>& infos() const override { return infos_; }
  BlockKind kind() const override { return {.constant_tangent = true, .linear_between_events = true}; }
  LawAsGiven law_of_block(std::size_t element) const override;
  std::span<const ReportedQuantity> quantities(std::size_t) const override { return {}; }
  /// Returns the stiffness of the stiffest degree of freedom, N/m.
  double linear_stiffness(std::size_t element, StiffnessStage stage) const override;
  double delivered_restitution(std::size_t element, double approach_speed) const override;
  void add_couplings(Couplings& couplings) const override;
  /// Adds its stiffness, scaled so that the largest entry of its diagonal is this one.
  void add_stiffness(std::size_t element, double stiffness, SparseMatrix& matrix) const override;
  std::unique_ptr<ElementStates> make_states(const SparseMatrix& matrix) const override;

 private:
  std::deque<ElementInfo> infos_;
  std::vector<StructureMatrices> matrices_;
};

}  // namespace moat
