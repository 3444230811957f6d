// Where the two ends of an element are attached, and how it scatters from there.
#pragma once

#include <array>
#include <cstddef>

#include "base/sparse_matrix.hpp"
#include "model/element_block.hpp"
#include "model/node.hpp"

namespace moat {

/// Both ends at nodes: difference = value(second) - value(first).
///
/// Global arrays have one entry more than there are degrees of freedom, the last for the ground, and matrices one
/// value more than nonzeros: nothing here asks whether a node is the ground.
class NodePair {
 public:
  NodePair() = default;
  explicit NodePair(const ElementInfo& info) : first_{info.first.index}, second_{info.second.index} {}

  void add_couplings(PatternBuilder& pattern) const { pattern.couple(first_, second_); }
  void find_slots(const SparseMatrix& matrix) {
    first_first_ = matrix.slot(first_, first_);
    first_second_ = matrix.slot(first_, second_);
    second_first_ = matrix.slot(second_, first_);
    second_second_ = matrix.slot(second_, second_);
    first_entry_ = first_ == ground_index ? matrix.size : first_;
    second_entry_ = second_ == ground_index ? matrix.size : second_;
  }
  [[nodiscard]] double difference(const double* values) const { return values[second_entry_] - values[first_entry_]; }
  void add_force(double force, double* forces) const {
    forces[second_entry_] += force;
    forces[first_entry_] -= force;
  }
  void add_stiffness(double stiffness, double* values) const {
    values[second_second_] += stiffness;
    values[first_first_] += stiffness;
    values[first_second_] -= stiffness;
    values[second_first_] -= stiffness;
  }

 private:
  int first_ = ground_index, second_ = ground_index;
  int first_entry_ = 0, second_entry_ = 0;
  int first_first_ = 0, first_second_ = 0, second_first_ = 0, second_second_ = 0;
};

/// A point on the straight line between two nodes, usually on a column between two floors:
///
///     u(point) = (1 - share) u(node) + share u(other)
///
/// A node alone is such a point with share 0. Points convert from NodeId, so that both can be written.
struct MemberPoint {
  NodeId node{};
  NodeId other{};
  double share = 0.0;  ///< 0 <= share < 1

  MemberPoint() = default;
  MemberPoint(NodeId at) : node{at}, other{at} {}
  MemberPoint(NodeId lower, NodeId upper, double share_of_upper) : node{lower}, other{upper}, share{share_of_upper} {}

  [[nodiscard]] bool is_node() const { return share == 0.0; }
};

/// Both ends at points between nodes: difference = sum of weight * value over up to four nodes.
class PointPair {
 public:
  PointPair() = default;
  PointPair(const MemberPoint& first, const MemberPoint& second)
      : node_{first.node.index, first.other.index, second.node.index, second.other.index},
        weight_{first.share - 1.0, -first.share, 1.0 - second.share, second.share} {}

  void add_couplings(PatternBuilder& pattern) const {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (weight_[i] != 0.0 && weight_[j] != 0.0) pattern.couple(node_[i], node_[j]);
  }
  void find_slots(const SparseMatrix& matrix) {
    for (std::size_t i = 0; i < count; ++i) {
      entry_[i] = node_[i] == ground_index ? matrix.size : node_[i];
      for (std::size_t j = 0; j < count; ++j)
        slot_[i][j] = weight_[i] != 0.0 && weight_[j] != 0.0 ? matrix.slot(node_[i], node_[j]) : matrix.nonzeros();
    }
  }
  [[nodiscard]] double difference(const double* values) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += weight_[i] * values[entry_[i]];
    return sum;
  }
  void add_force(double force, double* forces) const {
    for (std::size_t i = 0; i < count; ++i) forces[entry_[i]] += weight_[i] * force;
  }
  void add_stiffness(double stiffness, double* values) const {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j) values[slot_[i][j]] += weight_[i] * weight_[j] * stiffness;
  }

 private:
  static constexpr std::size_t count = 4;
  std::array<int, count> node_{ground_index, ground_index, ground_index, ground_index};
  std::array<double, count> weight_{};
  std::array<int, count> entry_{};
  std::array<std::array<int, count>, count> slot_{};
};

}  // namespace moat
