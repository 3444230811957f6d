#include "elements/line/lead_rubber_bearing.hpp"

#include <numbers>

#include "elements/line/isolator.hpp"

namespace moat {

void BearingDesign::check(const Check& check) const {
  check.not_negative("weight", weight);
  check.that((characteristic_strength != Force{}) != (strength_ratio != 0.0),
             "characteristic_strength and strength_ratio are both given, or neither.", "Give one of them.");
  if (strength_ratio != 0.0)
    check.that(strength_ratio > 0.0 && strength_ratio < 1.0, "strength_ratio", strength_ratio, "1", "> 0 and < 1",
               "6 % of the weight is 0.06.");
  else
    check.positive("characteristic_strength", characteristic_strength);
  check.positive("isolation_period", isolation_period);
  check.positive("yield_displacement", yield_displacement);
}

std::vector<Parameter> BearingDesign::parameters() const {
  const Parameter strength = strength_ratio != 0.0
                                 ? Parameter{"strength_ratio", strength_ratio, "1"}
                                 : Parameter{"characteristic_strength", characteristic_strength.si(), "N"};
  return {
      strength, {"isolation_period", isolation_period.si(), "s"}, {"yield_displacement", yield_displacement.si(), "m"}};
}

Bilinear BearingDesign::carrying(Force load) const {
  const double frequency = 2.0 * std::numbers::pi / isolation_period.si();
  const Stiffness post_yield = load.si() / standard_gravity * frequency * frequency * units::N / units::m;
  const Force strength = strength_ratio != 0.0 ? strength_ratio * load : characteristic_strength;
  return {.yield_force = strength + post_yield * yield_displacement.value(),
          .yield_displacement = yield_displacement,
          .post_yield_stiffness = post_yield};
}

LeadRubberBearing LeadRubberBearing::from_design(const BearingDesign& design) {
  const Check check{"LeadRubberBearing::from_design", ""};
  check.positive("weight", design.weight, "Give the weight that the bearings carry, m g.");
  design.check(check);
  const Bilinear law = design.carrying(design.weight);
  return {.yield_force = law.yield_force,
          .yield_displacement = law.yield_displacement,
          .post_yield_stiffness = law.post_yield_stiffness};
}

void add(Model& model, const LeadRubberBearing& bearing) {
  add_link(model, "LeadRubberBearing", isolator_info(bearing.name, bearing.lower, bearing.upper),
           Bilinear{.yield_force = bearing.yield_force,
                    .yield_displacement = bearing.yield_displacement,
                    .post_yield_stiffness = bearing.post_yield_stiffness});
}

}  // namespace moat
