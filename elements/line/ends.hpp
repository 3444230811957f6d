// Where the two ends of an element are attached, and how it scatters from there.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "model/element_block.hpp"
#include "model/member_point.hpp"
#include "model/node.hpp"

namespace moat {

/// Both ends at nodes: difference = value(second) - value(first).
///
/// Global arrays have one entry more than there are degrees of freedom, the last for the ground.
class NodePair {
 public:
  NodePair() = default;
  /// The nodes come with each call.
  explicit NodePair(const ElementInfo&) {}

  /// Adds the pairs of degrees of freedom that stiffness couples.
  void add_couplings(const ElementInfo& info, Couplings& couplings) const {
    couplings.couple(info.first.index, info.second.index);
  }
  /// Keeps the positions of both ends in global arrays.
  void find_entries(const ElementInfo& info, const SparseMatrix& matrix) {
    const int of_ground = static_cast<int>(matrix.cols());
    first_ = info.first == ground ? of_ground : info.first.index;
    second_ = info.second == ground ? of_ground : info.second.index;
  }
  /// Returns the difference in a global array: value at `second` minus value at `first`.
  [[nodiscard]] double difference(const double* values) const { return values[second_] - values[first_]; }
  /// Adds the force to `second` and takes it from `first`, N.
  void add_force(double force, double* forces) const {
    forces[second_] += force;
    forces[first_] -= force;
  }

  /// The positions of an element's stiffness in the values of the matrix.
  class Slots {
   public:
    /// Keeps the positions in the values of the matrix.
    void find(const NodePair& ends, const SparseMatrix& matrix) {
      const auto index = [&](int entry) { return entry == matrix.cols() ? ground_index : entry; };
      const int first = index(ends.first_), second = index(ends.second_);
      first_first_ = entry_position(matrix, first, first);
      first_second_ = entry_position(matrix, first, second);
      second_first_ = entry_position(matrix, second, first);
      second_second_ = entry_position(matrix, second, second);
    }
    /// Adds a stiffness between both ends, N/m.
    void add_stiffness(const NodePair&, double stiffness, double* values) const {
      add_to_entry(values, second_second_, stiffness);
      add_to_entry(values, first_first_, stiffness);
      add_to_entry(values, first_second_, -stiffness);
      add_to_entry(values, second_first_, -stiffness);
    }

   private:
    int first_first_ = 0, first_second_ = 0, second_first_ = 0, second_second_ = 0;
  };

 private:
  int first_ = 0, second_ = 0;
};

/// Both ends at points between nodes: difference = sum of weight * value over up to four nodes, each of them once. A
/// node on both sides has the sum of its weights, which is zero where it moves both sides alike.
class PointPair {
  static constexpr std::size_t count = 4;

 public:
  PointPair() = default;
  /// The nodes of `info`.
  explicit PointPair(const ElementInfo& info) : PointPair{info.first, info.second} {}
  /// Both points at rest at equal displacements.
  PointPair(const MemberPoint& first, const MemberPoint& second)
      : node_{first.node.index, first.other.index, second.node.index, second.other.index},
        weight_{first.share - 1.0, -first.share, 1.0 - second.share, second.share} {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (node_[i] != node_[j]) continue;
        weight_[j] += weight_[i];
        weight_[i] = 0.0;
      }
    }
    // Sums of shares that cancel leave round-off.
    for (double& weight : weight_)
      if (std::abs(weight) < 1e-12) weight = 0.0;
  }

  /// The sum of weight^2/mass over the nodes, 1/kg: the change of the difference under a unit impulse. `inverse_mass`
  /// is called with indices of nodes, never with the ground's.
  template <class InverseMass>
  [[nodiscard]] double mobility(InverseMass inverse_mass) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i)
      if (weight_[i] != 0.0 && node_[i] != ground_index) sum += weight_[i] * weight_[i] * inverse_mass(node_[i]);
    return sum;
  }

  /// Adds the pairs of degrees of freedom that stiffness couples.
  void add_couplings(const ElementInfo&, Couplings& couplings) const {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (weight_[i] != 0.0 && weight_[j] != 0.0) couplings.couple(node_[i], node_[j]);
  }
  /// Keeps the positions of the nodes in global arrays.
  void find_entries(const ElementInfo&, const SparseMatrix& matrix) {
    for (std::size_t i = 0; i < count; ++i)
      entry_[i] = node_[i] == ground_index ? static_cast<int>(matrix.cols()) : node_[i];
  }
  /// Returns the difference in a global array: value at the second point minus value at the first.
  [[nodiscard]] double difference(const double* values) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += weight_[i] * values[entry_[i]];
    return sum;
  }
  /// Adds the force to the second point and takes it from the first, N.
  void add_force(double force, double* forces) const {
    for (std::size_t i = 0; i < count; ++i) forces[entry_[i]] += weight_[i] * force;
  }

  /// The positions of an element's stiffness in the values of the matrix.
  class Slots {
   public:
    /// Keeps the positions in the values of the matrix.
    void find(const PointPair& ends, const SparseMatrix& matrix) {
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
          slot_[i][j] = ends.weight_[i] != 0.0 && ends.weight_[j] != 0.0
                            ? entry_position(matrix, ends.node_[i], ends.node_[j])
                            : -1;
    }
    /// Adds a stiffness between both points, N/m.
    void add_stiffness(const PointPair& ends, double stiffness, double* values) const {
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
          add_to_entry(values, slot_[i][j], ends.weight_[i] * ends.weight_[j] * stiffness);
    }

   private:
    std::array<std::array<int, count>, count> slot_{};
  };

 private:
  std::array<int, count> node_{ground_index, ground_index, ground_index, ground_index};
  std::array<double, count> weight_{};
  std::array<int, count> entry_{};
};

}  // namespace moat
