// Both ends of an element at points in plan.
#pragma once

#include <utility>
#include <vector>

#include "elements/block/ends.hpp"
#include "elements/block/plan_point.hpp"

namespace moat {

/// Displacements of one point relative to another along two directions at right angles, x and y or normal and tangent;
/// those of `second` have the sign plus.
class PlanEnds : public EndsOf<PlanVector> {
 public:
  PlanEnds() = default;
  /// Points of different bodies, along a direction of length 1 and across, turned by +90 degrees.
  PlanEnds(const Model& model, const PlanPoint& first, const PlanPoint& second, PlanVector direction) {
    for (const auto& [point, sign] : {std::pair{&first, -1.0}, {&second, 1.0}}) {
      add_body(model, point->of, point->at, sign * (1.0 - point->share), direction);
      if (!point->is_on_body()) add_body(model, point->other, point->at, sign * point->share, direction);
    }
  }

  [[nodiscard]] const WeightedEnds& along() const { return along_; }    ///< The difference along the direction.
  [[nodiscard]] const WeightedEnds& across() const { return across_; }  ///< The difference across it.
  /// The change of either difference under a unit impulse along the other, 1/kg.
  [[nodiscard]] double cross_mobility(const MassMatrix& mass) const {
    std::vector<int> indices;
    std::vector<double> along, across;
    for (const Term& term : terms()) {
      indices.push_back(term.index);
      along.push_back(term.weight.x);
      across.push_back(term.weight.y);
    }
    return mass.mobility(indices, along, across);
  }

 private:
  void add_body(const Model& model, NodeId body, PlanPosition at, double share, PlanVector direction) {
    const PlanRow along = row_of(model, body, at, direction), across = row_of(model, body, at, turned_left(direction));
    for (std::size_t i = 0; i < along.node.size(); ++i) {
      add(model, along.node[i], share * PlanVector{along.weight[i], across.weight[i]});
      along_.add(model, along.node[i], share * along.weight[i]);
      across_.add(model, along.node[i], share * across.weight[i]);
    }
  }

  WeightedEnds along_, across_;
};

}  // namespace moat
