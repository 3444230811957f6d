// Any force-deformation law along a direction in plan.
#pragma once

#include "elements/block/link_block.hpp"
#include "elements/block/plan_ends.hpp"

namespace moat {

/// Any force-deformation law (materials/response.hpp) between two points in plan, along one direction n:
///
///     d = (u_upper - u_lower) . n      the law's force pulls `upper` back along n, and `lower` forth
///
/// Springs, dashpots and one-way bearings of a floor are such elements; moments about the centres of mass follow from
/// the positions of the points. Reports deformation [m] and force [N] under its name, unless the names are empty.
template <ForceLaw Law>
struct PlanSpring {
  std::string name;           ///< Unique in its model.
  Required<PlanPoint> lower;  ///< The lower end, or `ground`.
  Required<PlanPoint> upper;  ///< The upper end.
  /// Any length > 0.
  PlanVector direction{1.0, 0.0};
  Law law;                                           ///< Gives the force from the deformation.
  std::string deformation_quantity = "deformation";  ///< Under which the deformation is reported, m.
  std::string force_quantity = "force";              ///< Under which the force is reported, N.
  /// Where its peaks are listed together with those of others; its own name if empty.
  std::string place{};
  bool isolates = false;  ///< Whether it separates a building from the ground.
};

/// Adds the law of a PlanSpring or a PlanarSpring, whose points were checked. The direction is zero for a law that acts
/// in both.
template <class Spring, class Ends>
void add_in_plan(Model& model, const Check& check, std::string_view kind, const Spring& spring, PlanVector direction,
                 const Ends& ends) {
  if constexpr (requires { spring.law.check(check); }) spring.law.check(check);
  model.register_element(kind, spring.name);
  const PlanPoint &lower = spring.lower, &upper = spring.upper;
  ElementDetails details;
  if constexpr (requires { spring.on_slab; }) {
    details.law_as_given = spring.law_as_given;
    details.bearing_on_slab = spring.on_slab;
  }
  model.block<LinkBlock<decltype(spring.law), Ends>>().add({.name = spring.name,
                                                            .place = spring.place,
                                                            .first = lower.of,
                                                            .second = upper.of,
                                                            .deformation_quantity = spring.deformation_quantity,
                                                            .force_quantity = spring.force_quantity,
                                                            .isolates = spring.isolates,
                                                            .drawn_as = DrawnAs::nothing,
                                                            .details = plan_details(lower, upper, direction, details)},
                                                           spring.law, ends);
}

/// Throws InputError for points that are not of this model or on the same body, a direction without length, a name
/// that is taken, or a parameter that the law refuses.
template <ForceLaw Law>
void add(Model& model, const PlanSpring<Law>& spring) {
  const PlanPoint &lower = spring.lower, &upper = spring.upper;
  const Check check = check_points(model, "PlanSpring", spring.name, "lower", lower, "upper", upper);
  const PlanVector direction = unit_direction(check, "direction", spring.direction);
  add_in_plan(model, check, "PlanSpring", spring, direction, PlanEnds{model, lower, upper, direction}.along());
}

}  // namespace moat
