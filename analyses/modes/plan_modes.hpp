// Modes of a model in plan.
#pragma once

#include <string>
#include <vector>

#include "base/stiffness_stage.hpp"
#include "model/model.hpp"

namespace moat {

/// A mode of vibration in plan.
struct PlanMode {
  double period = 0.0;  ///< s
  /// Shares of the model's whole mass that follow a motion of the ground along x and y: (phi M iota)^2/(phi M phi) over
  /// the sum of the masses. Over all modes each adds up to 1.
  double participation_x = 0.0, participation_y = 0.0;
  /// The share of the mode's kinetic energy that is in rotations, 0 to 1.
  double rotation = 0.0;
  Vector shape;  ///< of all degrees of freedom, m, with phi M phi = 1 kg m^2

  /// "x", "y", "torsion", or "x-torsion" and the like where a direction has at least a fifth of the kinetic energy.
  [[nodiscard]] std::string character() const;
  /// Shares of its kinetic energy.
  double along_x = 0.0, along_y = 0.0;
};

/// The slowest modes of the model, at most `count`. `stage` says which stiffness bearings that yield have. Throws
/// InputError for a model on a line and for count < 1, std::runtime_error where the modes cannot be computed.
std::vector<PlanMode> plan_modes(const Model& model, StiffnessStage stage, int count);

}  // namespace moat
