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
  double along_x = 0.0, along_y = 0.0;  ///< shares of its kinetic energy
};

/// The slowest modes of the model, at most `count`. `stage` says which stiffness bearings that yield have. Throws
/// InputError for a model on a line and for count < 1, std::runtime_error where the modes cannot be computed.
std::vector<PlanMode> plan_modes(Model& model, StiffnessStage stage, int count);

/// Torsional amplification of an isolated building: the largest displacement of a corner over that of the centre of
/// mass, by ASCE 7-16 Eq. 17.5-3,
///
///     D_TM/D_M = 1 + (y/P_T^2) 12 e/(b^2 + d^2) >= 1.15
///
/// with the distance y from the centre of rigidity to the corner, across the motion, the eccentricity e, the plan
/// dimensions b and d, and the ratio P_T of translational to torsional period. All > 0 m; e >= 0.
struct TorsionalAmplification {
  double of_formula = 1.0;  ///< without the lower bound
  double of_code = 1.15;    ///< with it
};
TorsionalAmplification torsional_amplification(Length y, Length eccentricity, Length b, Length d, double period_ratio);
/// P_T = sqrt(sum(x_i^2 + y_i^2)/N)/r_I >= 1 of bearings at these places from the centre of rigidity, with the radius
/// of gyration r_I, m, of the isolated building.
double torsional_period_ratio(const std::vector<PlanPosition>& bearings, Length gyration);

}  // namespace moat
