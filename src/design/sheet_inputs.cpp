#include "design/sheet_inputs.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "materials/carried_weight.hpp"

namespace moat {

void IsolationLoop::check(const Check& check) const {
  check.positive("isolation.characteristic_strength", characteristic_strength);
  check.positive("isolation.post_yield_stiffness", post_yield_stiffness, "Isolators without one do not come back.");
  check.positive("isolation.yield_displacement", yield_displacement);
}

IsolationLoop IsolationLoop::times(const PropertyFactors& factors) const {
  return {factors.strength * characteristic_strength.value(), factors.stiffness * post_yield_stiffness.value(),
          yield_displacement};
}

Force IsolationLoop::yield_force() const {
  return characteristic_strength.value() + post_yield_stiffness.value() * yield_displacement.value();
}

Force IsolationLoop::force(Length displacement) const {
  if (displacement <= yield_displacement.value()) return displacement / yield_displacement.value() * yield_force();
  return characteristic_strength.value() + post_yield_stiffness.value() * displacement;
}

Stiffness IsolationLoop::stiffness(Length amplitude) const { return force(amplitude) / amplitude; }

double IsolationLoop::damping_ratio(Length amplitude) const {
  if (amplitude <= yield_displacement.value()) return 0.0;
  return 2.0 * characteristic_strength.value() * (amplitude - yield_displacement.value()) /
         (std::numbers::pi * force(amplitude) * amplitude);
}

SheetIsolation::SheetIsolation(IsolationLoop loop) : loop_{[loop](Force, const Check&) { return loop; }} {}

SheetIsolation::SheetIsolation(BearingDesign design)
    : loop_{[design](Force weight, const Check& check) {
        design.check(check);
        return SheetIsolation{design.carrying(weight_on(check, design.weight, weight))}.under(weight, check);
      }} {}

SheetIsolation::SheetIsolation(FrictionPendulum law)
    : loop_{[law = std::move(law)](Force weight, const Check& check) {
        law.check(check);
        const Force carried = weight_on(check, law.weight, weight);
        return IsolationLoop{law.friction.value().fast(carried.si()) * carried, carried / law.radius.value(),
                             law.yield_displacement};
      }} {}

IsolationLoop SheetIsolation::under(Force weight, const Check& check) const {
  const IsolationLoop loop = loop_(weight, check);
  loop.check(check);
  return loop;
}

void SheetBuilding::check(const Check& check) const {
  check.positive("weight", weight);
  check.that(!floors.empty(), "floors are missing.", "Give weight and height of every floor above the base.");
  Force sum{};
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const std::string floor = "floor " + std::to_string(i + 1);
    check.positive("weight of " + floor, floors[i].weight);
    check.positive("height of " + floor, floors[i].height, "The forces of floors need it; it counts from the base.");
    sum += floors[i].weight;
  }
  check.that(sum <= weight.value(), "weight of all floors", sum.si(), "N",
             "<= weight = " + to_text(weight.si()) + " N, with the base level");
  check_factors(bounds);
  check.positive("shorter_side", shorter_side);
  check.that(longer_side.value() >= shorter_side.value() && std::isfinite(longer_side.si()), "longer_side",
             longer_side.si(), "m", ">= shorter_side = " + to_text(shorter_side.si()) + " m and finite");
  check.that(!bearings.empty(), "bearings are missing.", "Give the places of all isolators, for the turning.");
  check.not_negative("eccentricity", eccentricity);
  check.not_negative("corner_distance", corner_distance);
  check.positive("fixed_base_period", fixed_base_period);
  if (clearance) check.not_negative("clearance", *clearance);
  if (!suite) return;
  for (const auto& [bound, values] :
       {std::pair{"lower", &suite->lower}, {"nominal", &suite->nominal}, {"upper", &suite->upper}}) {
    const std::string prefix = "suite." + std::string{bound} + ".";
    check.not_negative(prefix + "displacement", values->displacement);
    check.not_negative(prefix + "corner_displacement", values->corner_displacement);
    check.not_negative(prefix + "base_shear", values->base_shear);
    check.not_negative(prefix + "storey_shear", values->storey_shear);
    check.not_negative(prefix + "drift", values->drift, "1");
  }
}

}  // namespace moat
