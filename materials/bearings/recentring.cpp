#include "materials/bearings/recentring.hpp"

#include <cmath>
#include <numbers>

#include "base/units.hpp"

namespace moat {

void Backbone::check(const Check& check) const {
  check.not_negative("strength", strength);
  check.positive("restoring_stiffness", restoring_stiffness, "Isolators without one do not come back.");
  check.positive("weight", weight);
}

std::vector<RestoringCheck> restoring_checks(const Backbone& backbone, Length displacement) {
  const Check check{"restoring_checks", ""};
  backbone.check(check);
  check.positive("displacement", displacement, "Give the design displacement.");
  const Stiffness stiffness = backbone.restoring_stiffness;
  const Force weight = backbone.weight;
  const double outer_half = 0.5 * stiffness * displacement / weight;
  const Time period = 2.0 * std::numbers::pi * sqrt(weight / (stiffness * units::g));
  // Infinite without friction.
  const double from_stuck = displacement / backbone.largest_stuck_displacement();
  const auto at_least = [](std::string_view rule, double value, double limit) {
    return RestoringCheck{rule, value, limit, "1", value >= limit};
  };
  return {at_least("ASCE 7-16, 17.2.4.4: (F(D) - F(D/2))/W >= 0.025", outer_half, 0.025),
          at_least("AASHTO Isolation: (F(D) - F(D/2))/W >= 1/80", outer_half, 1.0 / 80.0),
          {"AASHTO Isolation: tangent period <= 6 s", period.si(), 6.0, "s", period.si() <= 6.0},
          at_least("EN 15129: stored over dissipated energy >= 0.25", 0.5 * from_stuck, 0.25),
          at_least("EN 1998-2, 7.7.1: D/d_r >= 0.5", from_stuck, 0.5)};
}

double accumulation_en_1998_2(Length displacement, Length yield_displacement, Length stuck_displacement) {
  const Check check{"accumulation_en_1998_2", ""};
  check.positive("yield_displacement", yield_displacement);
  check.positive("stuck_displacement", stuck_displacement);
  check.that(displacement >= yield_displacement && std::isfinite(displacement.si()), "displacement", displacement.si(),
             "m", ">= yield_displacement and finite");
  return 1.0 + 1.35 * (1.0 - std::pow(yield_displacement / displacement, 0.6)) /
                   (1.0 + 80.0 * std::pow(displacement / stuck_displacement, 1.5));
}

Length displacement_demand_en_1998_2(Length offset, Length displacement, Length yield_displacement,
                                     Length stuck_displacement) {
  Check{"displacement_demand_en_1998_2", ""}.not_negative("offset", offset);
  return offset + 1.20 * accumulation_en_1998_2(displacement, yield_displacement, stuck_displacement) * displacement;
}

}  // namespace moat
