#include "elements/line/lead_rubber_bearing.hpp"

#include <numbers>

#include "elements/line/isolator.hpp"
#include "materials/bilinear.hpp"

namespace moat {

LeadRubberBearing LeadRubberBearing::from_design(const BearingDesign& design) {
  const Check check{"LeadRubberBearing::from_design", ""};
  check.positive("weight", design.weight, "Give the weight that the bearings carry, m g.");
  check.positive("characteristic_strength", design.characteristic_strength);
  check.positive("isolation_period", design.isolation_period);
  check.positive("yield_displacement", design.yield_displacement);
  const double frequency = 2.0 * std::numbers::pi / design.isolation_period.si();
  const Stiffness post_yield = design.weight.si() / standard_gravity * frequency * frequency * units::N / units::m;
  return {.yield_force = design.characteristic_strength.value() + post_yield * design.yield_displacement.value(),
          .yield_displacement = design.yield_displacement,
          .post_yield_stiffness = post_yield};
}

void add(Model& model, const LeadRubberBearing& bearing) {
  add_link(model, "LeadRubberBearing", isolator_info(bearing.name, bearing.lower, bearing.upper),
           Bilinear{.yield_force = bearing.yield_force,
                    .yield_displacement = bearing.yield_displacement,
                    .post_yield_stiffness = bearing.post_yield_stiffness});
}

}  // namespace moat
