// The moment of forces from outside on a building.
#pragma once

#include <span>
#include <vector>

#include "base/copyable_pointer.hpp"
#include "base/plan_vector.hpp"
#include "model/building.hpp"
#include "model/element_states.hpp"

namespace moat {

/// The forces on a building of all elements that have one end in it and the other outside, but for its bearings: walls,
/// neighbours, dampers to the ground. They act at their heights above the bearings.
class OutsideForces {
 public:
  using Elements = std::vector<CopyablePointer<ElementStates>>;  ///< One for each block.

  OutsideForces() = default;  ///< Holds no forces.
  /// Sums the forces on the bodies of these nodes; `level` m is the height of the bearings.
  OutsideForces(const Model& model, std::span<const NodeId> nodes, std::span<const ElementId> bearings, double level);

  /// The sums of force times height along x and y, N m, or their rates, N m/s.
  [[nodiscard]] PlanVector moment(const Model& model, const Elements& elements, bool of_rates) const;

 private:
  struct Force {
    ElementId element;
    double arm;  // m, its height; negative where it acts on the second end of the element
  };

  std::vector<Force> forces_;
};

}  // namespace moat
