// The storeys of a building in plan: their springs and dashpots, and sums of their forces.
#pragma once

#include <string>
#include <vector>

#include "base/check.hpp"
#include "model/building.hpp"
#include "model/model.hpp"
#include "structures/plan_parts.hpp"

namespace moat {

/// A spring of a storey.
struct StoreySpring {
  std::string name;
  double stiffness;        ///< N/m along the direction, N m/rad against rotation
  PlanPosition at{};       ///< where it acts
  PlanVector direction{};  ///< of length 1; zero: against rotation

  [[nodiscard]] bool turns() const { return direction == PlanVector{}; }  ///< Whether it acts against rotation.
};

/// A storey, from the floor below it, or the ground, to its own.
struct PlanStorey {
  std::string name;
  NodeId lower;
  DiaphragmId upper;
  double height;  ///< m; 0 where it is not given
  std::vector<StoreySpring> springs;
};

/// The springs of columns under a floor with this outline. Throws InputError for a bad stiffness.
std::vector<StoreySpring> springs_of_storey(const Check& check, const PlanColumns& columns, const PlanOutline& outline,
                                            const std::string& storey);

/// Adds the springs of a storey.
void add_springs(Model& model, const PlanStorey& storey);
/// Adds a dashpot beside each of them, `factor` s times as strong.
void add_dashpots(Model& model, const PlanStorey& storey, double factor);
/// Adds dashpots, `factor` 1/s times as strong as a floor is heavy, against its motion relative to the rigid motion of
/// the base, at its centre of mass.
void add_mass_damping(Model& model, NodeId base, DiaphragmId floor, double factor);

/// Shears and torque of the columns of every storey, and the moments of the forces on all floors above its lower one.
/// The torque is about `origin`.
std::vector<StoreyResult> storey_results(const Model& model, const std::vector<PlanStorey>& storeys, PlanVector origin);

}  // namespace moat
