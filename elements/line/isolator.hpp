// A law that carries a building on the ground and lets it move.
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "elements/block/link_checks.hpp"
#include "materials/carried_weight.hpp"
#include "materials/repeated.hpp"
#include "model/model.hpp"

namespace moat {

/// A law of force and deformation, or parameters that become one with the weight on them.
template <class Law>
concept IsolatorLaw = ForceLaw<Law> || WeightBearing<Law>;

/// The isolators of a building taken together, with any force-deformation law (materials/response.hpp).
///
///      [ upper ] -> u         count * law(u_upper - u_lower, v_upper - v_lower)
///     ===law====
///     ////ground///
///
/// If the law has `check(const Check&)`, that is called. Reports `isolator_force` [N] and `isolator_deformation` [m]
/// under its name, positive to the right, and the quantities of its law. Characteristic periods hold the node above it.
template <IsolatorLaw Law>
struct Isolator {
  std::string name = "bearings";  ///< Unique in its model.
  NodeId lower = ground;          ///< The node below, or `ground`.
  /// The floor on it. A ShearBuilding sets it; give it when you add an isolator yourself.
  NodeId upper{};
  Law law;  ///< Gives the force from the deformation.
  /// >= 1: of equal bearings side by side, each with this law.
  int count = 1;
  /// > 0 N on all of them, for laws that need it (pendulums, sliders); a ShearBuilding sets it.
  Force weight{};
  /// Position along the line, from the middle of the building; for AxialForces.
  Length at{};
  /// > 0 N/m of all of them, for AxialForces; left out: the same for every bearing.
  Stiffness vertical_stiffness{};
  /// Whether `weight` is that at rest, of a building with AxialForces. A ShearBuilding sets it.
  bool weight_changes = false;

  /// Returns the weight that the law states, on all bearings, or this isolator; 0 N where neither does.
  [[nodiscard]] Force own_weight() const {
    if constexpr (WeightBearing<Law>)
      if (law.weight.si() > 0.0) return count * law.weight;
    return weight;
  }
};

/// Parameters that become a law under a weight that changes.
template <class Design>
concept BearsChangingWeight = requires(const Design& design, Force weight) {
  { design.under_changing_weight(weight) } -> AxialForceLaw;
};

/// Throws InputError where the friction force of a design does not rise with the weight on it.
template <class Design>
void check_rising_friction(const Check& check, const Design& design, Force static_weight) {
  if constexpr (requires { check_rising(check, design.friction.value(), static_weight.si()); })
    check_rising(check, design.friction.value(), static_weight.si());
}

/// The details of a bearing under a changing weight: `design` its law or parameters.
template <class Design>
BearingOnSlab bearing_on_slab(const Design& design, PlanVector at, Force static_weight, Stiffness vertical_stiffness) {
  BearingOnSlab on_slab{.at = at, .static_weight = static_weight.si(), .vertical_stiffness = vertical_stiffness.si()};
  if constexpr (BearsChangingWeight<Design> && !requires { Design::is_rubber; }) {
    on_slab.slides = true;
    on_slab.acts_at = BearingOnSlab::by_surface;
    if constexpr (requires { design.share_of_upper_surfaces(); }) on_slab.acts_at = design.share_of_upper_surfaces();
  }
  return on_slab;
}

/// The quantities that every isolator reports.
inline ElementInfo isolator_info(const std::string& name, NodeId lower, NodeId upper) {
  return {.name = name,
          .first = lower,
          .second = upper,
          .deformation_quantity = "isolator_deformation",
          .force_quantity = "isolator_force",
          .isolates = true,
          .drawn_as = DrawnAs::bearing};
}

/// Throws InputError for unknown, missing or equal nodes, a name that is taken, or a parameter that the law refuses.
template <IsolatorLaw Law>
void add(Model& model, const Isolator<Law>& isolator) {
  const Check check =
      check_link(model, "Isolator", isolator.name, {"lower", isolator.lower}, {"upper", isolator.upper});
  if constexpr (requires { isolator.law.check(check); }) isolator.law.check(check);
  check.that(isolator.count >= 1, "count", isolator.count, "", ">= 1");
  ElementInfo info = isolator_info(isolator.name, isolator.lower, isolator.upper);
  std::vector<Parameter> given = parameters_of(isolator.law);
  const auto place = [&](const auto& law) {
    using Placed = std::remove_cvref_t<decltype(law)>;
    model.register_element("Isolator", isolator.name);
    if (isolator.count > 1) given.push_back({"count", static_cast<double>(isolator.count), "1"});
    // Reports show the law as the script gave it.
    ElementDetails details;
    if (isolator.count > 1 || !std::is_same_v<Placed, Law>)
      details.law_as_given = LawAsGiven{std::string{name_of(isolator.law)}, given};
    if (isolator.weight_changes) {
      details.bearing_on_slab =
          bearing_on_slab(isolator.law, {isolator.at.si(), 0.0}, isolator.own_weight(), isolator.vertical_stiffness);
      details.bearing_on_slab->count = isolator.count;
    }
    if (details.law_as_given || details.bearing_on_slab)
      info.details = std::make_shared<const ElementDetails>(std::move(details));
    if (isolator.count == 1)
      model.block<LinkBlock<Placed>>().add(info, law);
    else
      model.block<LinkBlock<Repeated<Placed>>>().add(info, {law, static_cast<double>(isolator.count)});
  };
  if constexpr (WeightBearing<Law>) {
    // The weight on one bearing.
    const Force weight = weight_on(check, isolator.law.weight, (1.0 / isolator.count) * isolator.weight);
    given.push_back({isolator.weight_changes ? "static_weight" : "weight", weight.si(), "N"});
    if constexpr (BearsChangingWeight<Law>) {
      if (isolator.weight_changes) {
        check_rising_friction(check, isolator.law, weight);
        return place(isolator.law.under_changing_weight(weight));
      }
    }
    place(isolator.law.carrying(weight));
  } else {
    place(isolator.law);
  }
}

}  // namespace moat
