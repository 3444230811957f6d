// Both ends of an element at points in plan, and how it scatters from there.
#pragma once

#include <array>
#include <cstddef>

#include "base/plan_vector.hpp"
#include "elements/line/ends.hpp"
#include "elements/plan/plan_point.hpp"

namespace moat {

/// Displacements of one point relative to another along two directions at right angles, x and y or normal and tangent,
/// with forces of two components and a tangent that need not be symmetric: difference = sum of weight * value over the
/// degrees of freedom of both bodies, those of `second` with the sign plus.
class PlanEnds {
  static constexpr std::size_t most = WeightedEnds::most;

 public:
  using Vector = PlanVector;  ///< of deformations and forces, along and across
  using Matrix = PlanMatrix;  ///< of stiffnesses

  PlanEnds() = default;
  /// Points of different bodies, along a direction of length 1 and across, turned by +90 degrees.
  PlanEnds(const Model& model, const PlanPoint& first, const PlanPoint& second, PlanVector direction) {
    for (const auto& [point, sign] : {std::pair{&first, -1.0}, {&second, 1.0}}) {
      const PlanRow along = row_of(model, *point, direction), across = row_of(model, *point, turned_left(direction));
      for (std::size_t i = 0; i < along.node.size(); ++i) {
        if (along.node[i] == ground) continue;
        nodes_[count_] = along.node[i].index;
        weights_[count_] = sign * PlanVector{along.weight[i], across.weight[i]};
        along_.add(along.node[i], sign * along.weight[i]);
        across_.add(along.node[i], sign * across.weight[i]);
        ++count_;
      }
    }
  }

  /// The difference along the direction.
  [[nodiscard]] const WeightedEnds& along() const { return along_; }
  /// The difference across it.
  [[nodiscard]] const WeightedEnds& across() const { return across_; }
  /// The change of either difference under a unit impulse along the other, 1/kg.
  [[nodiscard]] double cross_mobility(const MassMatrix& mass) const {
    std::array<double, most> along{}, across{};
    for (std::size_t i = 0; i < count_; ++i) {
      along[i] = weights_[i].x;
      across[i] = weights_[i].y;
    }
    return mass.mobility({nodes_.data(), count_}, {along.data(), count_}, {across.data(), count_});
  }

  /// As NodePair.
  void add_couplings(Couplings& couplings) const {
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = 0; j < count_; ++j) couplings.couple(nodes_[i], nodes_[j]);
  }
  /// As WeightedEnds.
  void put_ground_at(int) {}
  /// Returns the differences in a global array, along and across.
  [[nodiscard]] PlanVector difference(const double* values) const {
    PlanVector sum;
    for (std::size_t i = 0; i < count_; ++i) sum += values[nodes_[i]] * weights_[i];
    return sum;
  }
  /// Adds a force, along and across, N.
  void add_force(PlanVector force, double* forces) const {
    for (std::size_t i = 0; i < count_; ++i) forces[nodes_[i]] += dot(weights_[i], force);
  }

  /// As NodePair::Slots.
  class Slots {
   public:
    Slots(const PlanEnds& ends, const SparseMatrix& matrix) {
      for (std::size_t i = 0; i < ends.count_; ++i)
        for (std::size_t j = 0; j < ends.count_; ++j)
          slot_[i][j] = entry_position(matrix, ends.nodes_[i], ends.nodes_[j]);
    }
    /// Adds a stiffness, along and across, N/m.
    void add_stiffness(const PlanEnds& ends, PlanMatrix stiffness, double* values) const {
      for (std::size_t i = 0; i < ends.count_; ++i) {
        const PlanVector a = ends.weights_[i];
        const PlanVector to{a.x * stiffness.xx + a.y * stiffness.yx, a.x * stiffness.xy + a.y * stiffness.yy};
        for (std::size_t j = 0; j < ends.count_; ++j) values[slot_[i][j]] += dot(to, ends.weights_[j]);
      }
    }

   private:
    std::array<std::array<int, most>, most> slot_{};
  };

 private:
  std::size_t count_ = 0;
  std::array<int, most> nodes_{};
  std::array<PlanVector, most> weights_{};
  WeightedEnds along_, across_;
};

}  // namespace moat
