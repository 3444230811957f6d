// Elements that deform in two directions at once.
#pragma once

#include <cstddef>

#include "base/plan_vector.hpp"
#include "base/stiffness_stage.hpp"

namespace moat {

/// The side of an ElementBlock whose elements have a deformation and a force of two components: bearings in plan.
/// Deformations and forces of ElementBlock::results() are then the lengths of these vectors.
class PlanarElements {
 public:
  /// Where the element stands at rest, m.
  [[nodiscard]] virtual PlanVector position(std::size_t element) const = 0;
  /// That of a linear analysis, in all directions alike, N/m.
  [[nodiscard]] virtual double linear_stiffness(std::size_t element, StiffnessStage stage) const = 0;
  /// Results of the last evaluate() and evaluate_rates(): m, m/s, N, N/s.
  [[nodiscard]] virtual PlanVector deformation(std::size_t element) const = 0;
  /// m/s
  [[nodiscard]] virtual PlanVector deformation_rate(std::size_t element) const = 0;
  /// N
  [[nodiscard]] virtual PlanVector force(std::size_t element) const = 0;
  /// N/s
  [[nodiscard]] virtual PlanVector force_rate(std::size_t element) const = 0;

 protected:
  ~PlanarElements() = default;
};

}  // namespace moat
