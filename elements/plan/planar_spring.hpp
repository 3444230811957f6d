// A force-deformation law of two components between two points in plan.
#pragma once

#include "elements/plan/plan_spring.hpp"

namespace moat {

/// A law of two components (materials/plan/planar_response.hpp) between two points in plan: F(u_upper - u_lower) in x
/// and y.
///
/// Reports `deformation` and `force` as resultants and, with "_x" and "_y", as components.
template <PlanarLaw Law>
struct PlanarSpring {
  std::string name;                                  ///< Unique in its model.
  Required<PlanPoint> lower;                         ///< The lower end, or `ground`.
  Required<PlanPoint> upper;                         ///< The upper end.
  Law law;                                           ///< Gives the force from the deformation.
  std::string deformation_quantity = "deformation";  ///< Under which the deformation is reported, m.
  std::string force_quantity = "force";              ///< Under which the force is reported, N.
  /// Where its peaks are listed together with those of others; its own name if empty.
  std::string place{};
  bool isolates = false;                     ///< Whether it separates a building from the ground.
  std::optional<LawAsGiven> law_as_given{};  ///< For reports, where the law follows from a design.
  std::optional<BearingOnSlab> on_slab{};    ///< Given where the building has AxialForces.
};

/// A bearing under a floor: a PlanarSpring between the ground and the floor above, at a position in plan. Reports
/// `isolator_force` [N] and `isolator_deformation` [m]. Its resistance to twisting is neglected.
template <PlanarLaw Law>
struct PlanBearing {
  std::string name;  ///< Unique in its model.
  /// The floor on it.
  Required<DiaphragmId> under;
  PlanPosition at{};  ///< Where it stands at rest.
  Law law;            ///< Gives the force from the deformation.
  /// Where its peaks are listed together with those of others; its own name if empty.
  std::string place{};
  std::optional<LawAsGiven> law_as_given{};  ///< For reports, where the law follows from a design.
  std::optional<BearingOnSlab> on_slab{};    ///< A building with AxialForces sets it.
};

/// Throws InputError for points that are not of this model or on the same body, a name that is taken, or a parameter
/// that the law refuses.
template <PlanarLaw Law>
void add(Model& model, const PlanarSpring<Law>& spring) {
  const PlanPoint &lower = spring.lower, &upper = spring.upper;
  const Check check = check_points(model, "PlanarSpring", spring.name, "lower", lower, "upper", upper);
  add_in_plan(model, check, "PlanarSpring", spring, {}, PlanEnds{model, lower, upper, {1.0, 0.0}});
}

/// Adds a bearing as a spring on the ground. Throws InputError as for a PlanarSpring.
template <PlanarLaw Law>
void add(Model& model, const PlanBearing<Law>& bearing) {
  add(model, PlanarSpring<Law>{.name = bearing.name,
                               .lower = PlanPoint{ground, bearing.at},
                               .upper = PlanPoint{bearing.under.value(), bearing.at},
                               .law = bearing.law,
                               .deformation_quantity = "isolator_deformation",
                               .force_quantity = "isolator_force",
                               .place = bearing.place,
                               .isolates = true,
                               .law_as_given = bearing.law_as_given,
                               .on_slab = bearing.on_slab});
}

}  // namespace moat
