// Both ends of an element at points in plan, and how it scatters from there.
#pragma once

#include <array>
#include <cstddef>

#include "base/plan_vector.hpp"
#include "elements/plan/plan_point.hpp"
#include "model/element_block.hpp"

namespace moat {

/// Displacements of one point relative to another, along one direction: difference = sum of weight * value over up to
/// six degrees of freedom, those of `second` with the sign plus. Only degrees of freedom with a weight are kept, and
/// never the ground. Global arrays are those of NodePair (elements/line/ends.hpp).
class PlanEnds {
 public:
  static constexpr std::size_t most = 6;  ///< Degrees of freedom.

  /// Whether degrees of freedom without a weight in this direction are kept, because another direction has one.
  enum class Keep { weighted, all };

  PlanEnds() = default;
  /// Points of different bodies.
  PlanEnds(const Model& model, const PlanPoint& first, const PlanPoint& second, PlanVector direction,
           Keep keep = Keep::weighted) {
    const PlanRow minus = row_of(model, first, direction), plus = row_of(model, second, direction);
    for (std::size_t i = 0; i < 3; ++i) append(minus.node[i], -minus.weight[i], keep);
    for (std::size_t i = 0; i < 3; ++i) append(plus.node[i], plus.weight[i], keep);
  }

  /// This difference less another one between points of the same two bodies; both must keep all.
  [[nodiscard]] PlanEnds minus(const PlanEnds& other) const {
    PlanEnds result;
    for (std::size_t i = 0; i < count_; ++i) result.append(node_[i], weight_[i] - other.weight_[i], Keep::weighted);
    return result;
  }

  /// Number of degrees of freedom, <= most.
  [[nodiscard]] std::size_t size() const { return count_; }
  /// Index of the degree of freedom i, 0 <= i < size().
  [[nodiscard]] int node(std::size_t i) const { return node_[i]; }
  /// Weight of the degree of freedom i, 0 <= i < size().
  [[nodiscard]] double weight(std::size_t i) const { return weight_[i]; }

  /// The sum of weight^2/mass, 1/kg: the change of the difference under a unit impulse. `inverse_mass` is called with
  /// indices of nodes.
  template <class InverseMass>
  [[nodiscard]] double mobility(InverseMass inverse_mass) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < count_; ++i) sum += weight_[i] * weight_[i] * inverse_mass(node_[i]);
    return sum;
  }

  /// Adds the pairs of degrees of freedom that stiffness couples.
  void add_couplings(const ElementInfo&, Couplings& couplings) const {
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = 0; j <= i; ++j) couplings.couple(node_[i], node_[j]);
  }
  /// Nothing to keep: indices are known from the start.
  void find_entries(const ElementInfo&, const SparseMatrix&) {}
  /// Returns the sum of weight * value over a global array.
  [[nodiscard]] double difference(const double* values) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < count_; ++i) sum += weight_[i] * values[node_[i]];
    return sum;
  }
  /// Adds weight * force to every degree of freedom.
  void add_force(double force, double* forces) const {
    for (std::size_t i = 0; i < count_; ++i) forces[node_[i]] += weight_[i] * force;
  }

  /// The positions of an element's stiffness in the values of the matrix.
  class Slots {
   public:
    /// Keeps the positions in the values of the matrix.
    void find(const PlanEnds& ends, const SparseMatrix& matrix) {
      for (std::size_t i = 0; i < ends.count_; ++i)
        for (std::size_t j = 0; j < ends.count_; ++j)
          slot_[i][j] = entry_position(matrix, ends.node_[i], ends.node_[j]);
    }
    /// Adds a stiffness along the direction, N/m.
    void add_stiffness(const PlanEnds& ends, double stiffness, double* values) const {
      for (std::size_t i = 0; i < ends.count_; ++i)
        for (std::size_t j = 0; j < ends.count_; ++j)
          values[slot_[i][j]] += ends.weight_[i] * ends.weight_[j] * stiffness;
    }

   private:
    std::array<std::array<int, most>, most> slot_{};
  };

 private:
  void append(int node, double weight, Keep keep) {
    if (node == ground_index || (weight == 0.0 && keep == Keep::weighted)) return;
    node_[count_] = node;
    weight_[count_] = weight;
    ++count_;
  }

  std::size_t count_ = 0;
  std::array<int, most> node_{};
  std::array<double, most> weight_{};
};

/// PlanEnds along two directions at right angles, x and y or normal and tangent, with forces of two components and a
/// tangent that need not be symmetric.
class PlanEndsBothWays {
  static constexpr std::size_t most = PlanEnds::most;

 public:
  PlanEndsBothWays() = default;
  /// Along a direction of length 1, and across, turned by +90 degrees.
  PlanEndsBothWays(const Model& model, const PlanPoint& first, const PlanPoint& second, PlanVector direction)
      : along_{model, first, second, direction, PlanEnds::Keep::all},
        across_{model, first, second, turned_left(direction), PlanEnds::Keep::all} {}

  /// The difference along the direction.
  [[nodiscard]] const PlanEnds& along() const { return along_; }
  /// The difference across it.
  [[nodiscard]] const PlanEnds& across() const { return across_; }

  /// Adds the pairs of degrees of freedom that stiffness couples.
  void add_couplings(Couplings& couplings) const {
    for (std::size_t i = 0; i < along_.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) couplings.couple(along_.node(i), along_.node(j));
  }
  /// Keeps the positions in the values of the matrix.
  void find(const ElementInfo&, const SparseMatrix& matrix) {
    for (std::size_t i = 0; i < along_.size(); ++i)
      for (std::size_t j = 0; j < along_.size(); ++j)
        slot_[i][j] = entry_position(matrix, along_.node(i), along_.node(j));
  }
  /// The sum of the products of both weights over mass, 1/kg: the change of either difference under a unit impulse
  /// along the other.
  template <class InverseMass>
  [[nodiscard]] double cross_mobility(InverseMass inverse_mass) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < along_.size(); ++i)
      sum += along_.weight(i) * across_.weight(i) * inverse_mass(along_.node(i));
    return sum;
  }
  /// Returns the differences in a global array, along and across.
  [[nodiscard]] PlanVector difference(const double* values) const {
    return {along_.difference(values), across_.difference(values)};
  }
  /// Adds a force, along and across, N.
  void add_force(PlanVector force, double* forces) const {
    for (std::size_t i = 0; i < along_.size(); ++i)
      forces[along_.node(i)] += along_.weight(i) * force.x + across_.weight(i) * force.y;
  }
  /// Adds a stiffness, along and across, N/m.
  void add_stiffness(PlanMatrix stiffness, double* values) const {
    for (std::size_t i = 0; i < along_.size(); ++i) {
      const double a = along_.weight(i), b = across_.weight(i);
      const double to_along = a * stiffness.xx + b * stiffness.yx, to_across = a * stiffness.xy + b * stiffness.yy;
      for (std::size_t j = 0; j < along_.size(); ++j)
        values[slot_[i][j]] += to_along * along_.weight(j) + to_across * across_.weight(j);
    }
  }

 private:
  PlanEnds along_, across_;
  std::array<std::array<int, most>, most> slot_{};
};

}  // namespace moat
