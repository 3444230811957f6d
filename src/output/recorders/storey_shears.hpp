// Shear of storeys that several elements carry together.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/plan_vector.hpp"
#include "model/analysis_state.hpp"

namespace moat {

/// The shear of storeys: the sum of the forces between the body below and the body above. On a line springs, which
/// report a force, count without dashpots. In plan columns, bearings and dashpots count together. A building that is
/// given by its matrix has the elastic force.
class StoreyShears {
 public:
  /// storeys: the bodies below and above each.
  StoreyShears(const Model& model, const std::vector<std::pair<NodeId, NodeId>>& storeys);

  /// Returns the shears of the last evaluation of the model, N, one for each storey: on a line with its sign, in plan
  /// the length of the sum of vectors. Valid until the next call.
  std::span<const double> evaluate(const AnalysisState& state);

 private:
  struct Part {
    std::size_t block, element, storey;
  };
  std::vector<Part> parts_;
  // The shear of a storey in a building that is given by its matrix.
  struct SumOfMotion {
    std::size_t storey;
    PlanVector along;
    std::vector<MotionShare> displacements;
  };
  std::vector<SumOfMotion> sums_of_motion_;
  std::vector<PlanVector> sums_;
  std::vector<double> shears_;
};

}  // namespace moat
