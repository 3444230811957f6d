// Both ends of an element at points in plan, and how it scatters from there.
#pragma once

#include <array>
#include <cstddef>

#include "base/plan_vector.hpp"
#include "base/sparse_matrix.hpp"
#include "elements/plan_point.hpp"
#include "model/element_block.hpp"

namespace moat {

/// Displacements of one point relative to another, along one direction: difference = sum of weight * value over up to
/// six degrees of freedom, those of `second` with the sign plus. Global arrays are those of NodePair
/// (elements/ends.hpp).
class PlanEnds {
 public:
  static constexpr std::size_t count = 6;

  PlanEnds() = default;
  /// Points of different bodies.
  PlanEnds(const Model& model, const PlanPoint& first, const PlanPoint& second, PlanVector direction) {
    const PlanRow minus = row_of(model, first, direction), plus = row_of(model, second, direction);
    for (std::size_t i = 0; i < 3; ++i) {
      node_[i] = minus.node[i];
      weight_[i] = -minus.weight[i];
      node_[i + 3] = plus.node[i];
      weight_[i + 3] = plus.weight[i];
    }
  }

  /// The difference of two differences, between points of the same two bodies.
  [[nodiscard]] PlanEnds minus(const PlanEnds& other) const {
    PlanEnds result = *this;
    for (std::size_t i = 0; i < count; ++i) result.weight_[i] -= other.weight_[i];
    return result;
  }

  [[nodiscard]] const std::array<int, count>& nodes() const { return node_; }
  [[nodiscard]] const std::array<double, count>& weights() const { return weight_; }

  /// The sum of weight^2/mass, 1/kg: the change of the difference under a unit impulse. `inverse_mass` is called with
  /// indices of nodes.
  template <class InverseMass>
  [[nodiscard]] double mobility(InverseMass inverse_mass) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i)
      if (node_[i] != ground_index) sum += weight_[i] * weight_[i] * inverse_mass(node_[i]);
    return sum;
  }

  void add_couplings(const ElementInfo&, PatternBuilder& pattern) const {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (weight_[i] != 0.0 && weight_[j] != 0.0) pattern.couple(node_[i], node_[j]);
  }
  void find_entries(const ElementInfo&, const SparseMatrix& matrix) {
    for (std::size_t i = 0; i < count; ++i) entry_[i] = node_[i] == ground_index ? matrix.size : node_[i];
  }
  [[nodiscard]] double difference(const double* values) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += weight_[i] * values[entry_[i]];
    return sum;
  }
  void add_force(double force, double* forces) const {
    for (std::size_t i = 0; i < count; ++i) forces[entry_[i]] += weight_[i] * force;
  }

  class Slots {
   public:
    void find(const PlanEnds& ends, const ElementInfo&, const SparseMatrix& matrix) {
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
          slot_[i][j] = ends.weight_[i] != 0.0 && ends.weight_[j] != 0.0 ? matrix.slot(ends.node_[i], ends.node_[j])
                                                                         : matrix.nonzeros();
    }
    void add_stiffness(const PlanEnds& ends, double stiffness, double* values) const {
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j) values[slot_[i][j]] += ends.weight_[i] * ends.weight_[j] * stiffness;
    }

   private:
    std::array<std::array<int, count>, count> slot_{};
  };

 private:
  std::array<int, count> node_{ground_index, ground_index, ground_index, ground_index, ground_index, ground_index};
  std::array<double, count> weight_{};
  std::array<int, count> entry_{};
};

/// The same along two directions at right angles, x and y or normal and tangent, with forces of two components and a
/// tangent that need not be symmetric.
class PlanEndsBothWays {
  static constexpr std::size_t count = PlanEnds::count;

 public:
  PlanEndsBothWays() = default;
  PlanEndsBothWays(const Model& model, const PlanPoint& first, const PlanPoint& second, PlanVector direction)
      : along_{model, first, second, direction}, across_{model, first, second, turned_left(direction)} {}

  [[nodiscard]] const PlanEnds& along() const { return along_; }
  [[nodiscard]] const PlanEnds& across() const { return across_; }

  void add_couplings(PatternBuilder& pattern) const {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (moves(i) && moves(j)) pattern.couple(along_.nodes()[i], along_.nodes()[j]);
  }
  void find(const ElementInfo& info, const SparseMatrix& matrix) {
    along_.find_entries(info, matrix);
    across_.find_entries(info, matrix);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j)
        slot_[i][j] = moves(i) && moves(j) ? matrix.slot(along_.nodes()[i], along_.nodes()[j]) : matrix.nonzeros();
  }
  [[nodiscard]] PlanVector difference(const double* values) const {
    return {along_.difference(values), across_.difference(values)};
  }
  void add_force(PlanVector force, double* forces) const {
    along_.add_force(force.x, forces);
    across_.add_force(force.y, forces);
  }
  void add_stiffness(PlanMatrix stiffness, double* values) const {
    const auto &a = along_.weights(), &b = across_.weights();
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j)
        values[slot_[i][j]] +=
            a[i] * (stiffness.xx * a[j] + stiffness.xy * b[j]) + b[i] * (stiffness.yx * a[j] + stiffness.yy * b[j]);
  }

 private:
  [[nodiscard]] bool moves(std::size_t i) const { return along_.weights()[i] != 0.0 || across_.weights()[i] != 0.0; }

  PlanEnds along_, across_;
  std::array<std::array<int, count>, count> slot_{};
};

}  // namespace moat
