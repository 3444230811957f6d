// Sizes of quantities, and scales of acceleration by which errors of a step are divided.
#pragma once

#include <cmath>
#include <vector>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"
#include "model/analysis_state.hpp"

namespace moat {

/// Sizes by degree of freedom. The two translations of a diaphragm are components of one vector: the size of either is
/// that of their resultant, so that no judgement depends on the axes of the model. Every other degree of freedom stands
/// for itself.
class Resultants {
 public:
  /// The model must be complete.
  explicit Resultants(const Model& model);

  /// Returns judge(size), where size(i, component) is the size at degree of freedom i of a quantity whose components
  /// are component(0), component(1) ... On a line it is the magnitude, without cost.
  template <class Judge>
  decltype(auto) with(const Judge& judge) const {
    if (partners_.empty()) return judge([](int i, const auto& component) { return std::abs(component(i)); });
    return judge([partners = partners_.data()](int i, const auto& component) {
      const double first = component(i);
      if (partners[i] == i) return std::abs(first);
      const double second = component(partners[i]);
      return std::sqrt(first * first + second * second);
    });
  }

  /// Gershgorin's bounds row by row: sums of the sizes of a row's entries. The size of the entries between two vectors
  /// is the largest stretch of their 2x2 matrix.
  [[nodiscard]] Vector row_sums(const SparseMatrix& matrix) const;

 private:
  [[nodiscard]] int partner(int i) const { return partners_.empty() ? i : partners_[static_cast<std::size_t>(i)]; }

  std::vector<int> partners_;  // the other component, or the degree of freedom itself; empty on a line
};

/// The scale of every node's absolute acceleration, m/s^2: its largest magnitude so far, which decays by a factor e in
/// one second; in plan that of the resultant of a diaphragm's translations.
///
/// A building here is a set of nodes that elements other than gaps connect: a light body that pounds elsewhere does not
/// loosen the tolerance of a building. While a building is in contact, accelerations of the impact enter the scales of
/// its nodes. When the last contact of the building ends, its scales return to those without contact, because an impact
/// is no measure of the motion that follows.
class AccelerationScales {
 public:
  /// `peak_ground_acceleration` >= 0 m/s^2; no scale is below 2 % of it.
  AccelerationScales(const AnalysisState& state, double peak_ground_acceleration);

  /// Contacts may have begun or ended.
  void regimes_changed(const AnalysisState& state);
  /// A step of h s was committed.
  void accepted(const AnalysisState& state, double h, GroundVector ground_acceleration);

  /// Writes or reads all scales.
  void archive(auto& archive) {
    archive(touching_, touched_before_, any_touching_, step_of_fade_, fade_, values_, outside_contact_);
  }

  /// The scale of every node, m/s^2, > 0.
  [[nodiscard]] const Vector& values() const { return values_; }

 private:
  double lowest_;
  Resultants resultants_;

  std::vector<int> building_;                    // of every node
  std::vector<char> touching_, touched_before_;  // of every building, now and before the last change
  bool any_touching_ = false;
  double step_of_fade_ = 0.0, fade_ = 1.0;  // the last step, s, and how much is left after it
  Vector values_;
  Vector outside_contact_;  // the same, without contacts; kept while there are any
  // Nodes that follow each other in one building.
  struct Run {
    int begin, end, building;
  };
  std::vector<Run> runs_;
};

}  // namespace moat
