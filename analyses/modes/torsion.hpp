// Torsion of isolated buildings.
#pragma once

#include <vector>

#include "model/model.hpp"
#include "output/files/case_result.hpp"

namespace moat {

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
/// Throws InputError for a parameter outside its range.
TorsionalAmplification torsional_amplification(Length y, Length eccentricity, Length b, Length d, double period_ratio);
/// P_T = sqrt(sum(x_i^2 + y_i^2)/N)/r_I >= 1 of bearings at these places from the centre of rigidity, with the radius
/// of gyration r_I, m, of the isolated building.
double torsional_period_ratio(const std::vector<PlanPosition>& bearings, Length gyration);

/// The torsion of every building on bearings of two components, from the peaks of a run: displacements of its base.
/// Empty for a model on a line. The eccentricity is that of the model, from the centre of mass of the whole building to
/// the centre of the stiffness of its bearings after yield, so that accidental eccentricity counts where the model has
/// it. Of the two directions the formula takes the worse; y reaches to the farthest corner from the centre of rigidity,
/// b and d are the sides of the rectangle around the outline, and r_I = sqrt((b^2 + d^2)/12).
std::vector<BuildingTorsion> torsion_of(const Model& model, const std::vector<Peak>& peaks);

}  // namespace moat
