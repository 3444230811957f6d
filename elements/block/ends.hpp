// Where the two ends of an element are attached, and how it scatters from there.
#pragma once

#include <algorithm>
#include <concepts>
#include <type_traits>
#include <vector>

#include "base/plan_vector.hpp"
#include "model/element_block.hpp"
#include "model/mass_matrix.hpp"
#include "model/model.hpp"
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

  /// A degree of freedom, by its index, and its weight.
  struct Term {
    int index;      ///< in global arrays
    Weight weight;  ///< 1, or of two directions
  };

  EndsOf() = default;
  /// At points between nodes, the second with the sign plus. A node on both sides has the sum of its weights, and is
  /// left out where that vanishes because it moves both sides alike.
  EndsOf(const Model& model, const MemberPoint& first,
         const MemberPoint& second) requires std::same_as<Weight, double> {
    add(model, first.node, first.share - 1.0);
    add(model, first.other, -first.share);
    add(model, second.node, 1.0 - second.share);
    add(model, second.other, second.share);
  }
  /// Adds a node, unless it is the ground or the weight is zero.
  void add(const Model& model, NodeId node, Weight weight) {
    for (const MotionShare& share : model.shares(node)) add(share.node.index, share.weight * weight);
  }

  /// All degrees of freedom.
  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
  /// The change of the difference under a unit impulse, 1/kg.
  [[nodiscard]] double mobility(const MassMatrix& mass) const requires std::same_as<Weight, double> {
    std::vector<int> indices;
    std::vector<double> weights;
    for (const Term& term : terms_) {
      indices.push_back(term.index);
      weights.push_back(term.weight);
    }
    return mass.mobility(indices, weights, weights);
  }

  /// Couples all degrees of freedom with each other, as NodePair does.
  void add_couplings(Couplings& couplings) const {
    for (const Term& a : terms_)
      for (const Term& b : terms_) couplings.couple(a.index, b.index);
  }
  /// Nothing to do: the ground is never among the degrees of freedom.
  void put_ground_at(int) {}
  /// Returns the weighted sum of the values, as NodePair does.
  [[nodiscard]] Weight difference(const double* values) const {
    Weight sum{};
    for (const Term& term : terms_) sum += values[term.index] * term.weight;
    return sum;
  }
  /// Adds the force by its weights, as NodePair does.
  void add_force(Weight force, double* forces) const {
    for (const Term& term : terms_) forces[term.index] += dot(term.weight, force);
  }

  /// Stands for NodePair::Slots.
  class Slots {
   public:
    /// Finds the places of the ends in the matrix.
    Slots(const EndsOf& ends, const SparseMatrix& matrix) {
      for (const Term& row : ends.terms_)
        for (const Term& column : ends.terms_) positions_.push_back(entry_position(matrix, row.index, column.index));
    }
    /// Adds a stiffness between both ends, N/m.
    void add_stiffness(const EndsOf& ends, Matrix stiffness, double* values) const {
      const int* position = positions_.data();
      for (const Term& row : ends.terms_)
        for (const Term& column : ends.terms_) values[*position++] += product(row.weight, column.weight, stiffness);
    }

   private:
    static double product(double a, double b, double stiffness) { return a * b * stiffness; }
    static double product(PlanVector a, PlanVector b, PlanMatrix stiffness) {
      return dot({a.x * stiffness.xx + a.y * stiffness.yx, a.x * stiffness.xy + a.y * stiffness.yy}, b);
    }
    std::vector<int> positions_;  // row by row
  };

 private:
  void add(int index, Weight weight) {
    auto known = std::ranges::find(terms_, index, &Term::index);
    if (known == terms_.end()) known = terms_.insert(known, {index, Weight{}});
    known->weight += weight;
    constexpr double round_off = 1e-12;
    if (dot(known->weight, known->weight) < round_off * round_off) terms_.erase(known);
  }

  std::vector<Term> terms_;
};

/// Between points on columns, and between points in plan along one direction.
using WeightedEnds = EndsOf<double>;

}  // namespace moat
