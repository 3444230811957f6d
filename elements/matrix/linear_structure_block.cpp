#include "elements/matrix/linear_structure_block.hpp"

#include <limits>
#include <utility>

#include "elements/matrix/linear_structure_states.hpp"

namespace moat {

void LinearStructureBlock::add(ElementInfo info, StructureMatrices matrices) {
  infos_.push_back(std::move(info));
  matrices_.push_back(std::move(matrices));
}

LawAsGiven LinearStructureBlock::law_of_block(std::size_t element) const {
  return {"LinearStructure", {{"degrees_of_freedom", static_cast<double>(matrices_[element].nodes.size()), "1"}}};
}

double LinearStructureBlock::linear_stiffness(std::size_t element, StiffnessStage stage) const {
  return stage == StiffnessStage::joined ? 1.0 : matrices_[element].largest_stiffness;
}

double LinearStructureBlock::delivered_restitution(std::size_t, double) const {
  return std::numeric_limits<double>::quiet_NaN();
}

void LinearStructureBlock::add_couplings(Couplings& couplings) const {
  for (const StructureMatrices& each : matrices_)
    for (const int row : each.all)
      for (const int column : each.all) couplings.couple(row, column);
}

void LinearStructureBlock::add_stiffness(std::size_t element, double stiffness, SparseMatrix& matrix) const {
  const StructureMatrices& each = matrices_[element];
  const double scale = stiffness / each.largest_stiffness;
  for (std::size_t i = 0; i < each.all.size(); ++i)
    for (std::size_t j = 0; j < each.all.size(); ++j)
      matrix.coeffRef(each.all[i], each.all[j]) +=
          scale * each.all_stiffness(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
}

std::unique_ptr<ElementStates> LinearStructureBlock::make_states(const SparseMatrix& matrix) const {
  return std::make_unique<LinearStructureStates>(*this, matrix);
}

}  // namespace moat
