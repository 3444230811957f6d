// Where the two ends of an element are attached, and how it scatters from there.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

#include "base/plan_vector.hpp"
#include "model/element_block.hpp"
#include "model/mass_matrix.hpp"
#include "model/node.hpp"

namespace moat {

/// Both ends at nodes: difference = value(second) - value(first).
///
/// Global arrays have one entry more than there are degrees of freedom, the last for the ground.
class NodePair {
 public:
  using Vector = double;  ///< of deformations and forces
  using Matrix = double;  ///< of stiffnesses

  NodePair() = default;
  /// Both nodes of `info`.
  explicit NodePair(const ElementInfo& info) : first_{info.first.index}, second_{info.second.index} {}

  /// Adds the pairs of degrees of freedom that stiffness couples.
  void add_couplings(Couplings& couplings) const { couplings.couple(first_, second_); }
  /// The entry of the ground in global arrays.
  void put_ground_at(int entry) {
    if (first_ == ground_index) first_ = entry;
    if (second_ == ground_index) second_ = entry;
  }
  /// Returns the difference in a global array: value at `second` minus value at `first`.
  [[nodiscard]] double difference(const double* values) const { return values[second_] - values[first_]; }
  /// Adds the force to `second` and takes it from `first`, N.
  void add_force(double force, double* forces) const {
    forces[second_] += force;
    forces[first_] -= force;
  }

  /// The positions of an element's stiffness in the values of a matrix.
  class Slots {
   public:
    /// Before put_ground_at().
    Slots(const NodePair& ends, const SparseMatrix& matrix)
        : first_first_{entry_position(matrix, ends.first_, ends.first_)},
          first_second_{entry_position(matrix, ends.first_, ends.second_)},
          second_first_{entry_position(matrix, ends.second_, ends.first_)},
          second_second_{entry_position(matrix, ends.second_, ends.second_)} {}
    /// Adds a stiffness between both ends, N/m.
    void add_stiffness(const NodePair&, double stiffness, double* values) const {
      add_to_entry(values, second_second_, stiffness);
      add_to_entry(values, first_first_, stiffness);
      add_to_entry(values, first_second_, -stiffness);
      add_to_entry(values, second_first_, -stiffness);
    }

   private:
    int first_first_, first_second_, second_first_, second_second_;
  };

 private:
  int first_ = 0, second_ = 0;
};

/// Weighted degrees of freedom, never the ground: difference = sum of weight * value. The weights are numbers, or
/// vectors for differences along two directions with a tangent that need not be symmetric.
template <class Weight>
class EndsOf {
 public:
  using Vector = Weight;                                                                  ///< As NodePair.
  using Matrix = std::conditional_t<std::is_same_v<Weight, double>, double, PlanMatrix>;  ///< As NodePair.
  static constexpr std::size_t most = 6;                                                  ///< degrees of freedom

  EndsOf() = default;
  /// At points between nodes, the second with the sign plus. A node on both sides has the sum of its weights, and is
  /// left out where that vanishes because it moves both sides alike.
  EndsOf(const MemberPoint& first, const MemberPoint& second) requires std::same_as<Weight, double> {
    add(first.node, first.share - 1.0);
    add(first.other, -first.share);
    add(second.node, 1.0 - second.share);
    add(second.other, second.share);
  }
  /// Adds a degree of freedom, unless it is the ground or the weight is zero.
  void add(NodeId node, Weight weight) {
    if (node == ground || weight == Weight{}) return;
    std::size_t i = 0;
    while (i < count_ && nodes_[i] != node.index) ++i;
    if (i == count_) weights_[count_++] = Weight{};
    nodes_[i] = node.index;
    weights_[i] += weight;
    constexpr double round_off = 1e-12;
    if (dot(weights_[i], weights_[i]) >= round_off * round_off) return;
    --count_;
    nodes_[i] = nodes_[count_];
    weights_[i] = weights_[count_];
  }

  /// The indices of all degrees of freedom.
  [[nodiscard]] std::span<const int> nodes() const { return {nodes_.data(), count_}; }
  /// Their weights.
  [[nodiscard]] std::span<const Weight> weights() const { return {weights_.data(), count_}; }
  /// The change of the difference under a unit impulse, 1/kg.
  [[nodiscard]] double mobility(const MassMatrix& mass) const requires std::same_as<Weight, double> {
    return mass.mobility(nodes(), weights(), weights());
  }

  /// As NodePair.
  void add_couplings(Couplings& couplings) const {
    for (const int a : nodes())
      for (const int b : nodes()) couplings.couple(a, b);
  }
  /// Nothing to do: the ground is never among the degrees of freedom.
  void put_ground_at(int) {}
  /// As NodePair.
  [[nodiscard]] Weight difference(const double* values) const {
    Weight sum{};
    for (std::size_t i = 0; i < count_; ++i) sum += values[nodes_[i]] * weights_[i];
    return sum;
  }
  /// As NodePair.
  void add_force(Weight force, double* forces) const {
    for (std::size_t i = 0; i < count_; ++i) forces[nodes_[i]] += dot(weights_[i], force);
  }

  /// As NodePair::Slots.
  class Slots {
   public:
    Slots(const EndsOf& ends, const SparseMatrix& matrix) {
      for (std::size_t i = 0; i < ends.count_; ++i)
        for (std::size_t j = 0; j < ends.count_; ++j)
          slot_[i][j] = entry_position(matrix, ends.nodes_[i], ends.nodes_[j]);
    }
    /// Adds a stiffness between both ends, N/m.
    void add_stiffness(const EndsOf& ends, Matrix stiffness, double* values) const {
      for (std::size_t i = 0; i < ends.count_; ++i)
        for (std::size_t j = 0; j < ends.count_; ++j)
          values[slot_[i][j]] += product(ends.weights_[i], ends.weights_[j], stiffness);
    }

   private:
    static double product(double a, double b, double stiffness) { return a * b * stiffness; }
    static double product(PlanVector a, PlanVector b, PlanMatrix stiffness) {
      return dot({a.x * stiffness.xx + a.y * stiffness.yx, a.x * stiffness.xy + a.y * stiffness.yy}, b);
    }
    std::array<std::array<int, most>, most> slot_{};
  };

 private:
  std::size_t count_ = 0;
  std::array<int, most> nodes_{};
  std::array<Weight, most> weights_{};
};

/// Between points on columns, and between points in plan along one direction.
using WeightedEnds = EndsOf<double>;

}  // namespace moat
