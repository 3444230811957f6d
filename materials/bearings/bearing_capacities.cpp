#include "materials/bearings/bearing_capacities.hpp"

namespace moat {

void BearingCapacities::check(const Check& check) const {
  if (rubber) rubber->check(check);
  const auto positive = [&](std::string_view name, const auto& given) {
    if (given) check.positive(name, *given, "Leave it out where it is not known.");
  };
  positive("slider_area", slider_area);
  positive("displacement_capacity", displacement_capacity);
  positive("stop", stop);
  positive("shear_capacity", shear_capacity);
  positive("strain_capacity", strain_capacity);
  positive("tension_capacity", tension_capacity);
  positive("pressure_capacity", pressure_capacity);
  positive("speed_capacity", speed_capacity);
  positive("pressure_speed_capacity", pressure_speed_capacity);
  positive("stroke", stroke);
  positive("force_capacity", force_capacity);
  check.not_negative("static_displacement", static_displacement);
  check.not_negative("static_rotation_x", static_rotation_x);
  check.not_negative("static_rotation_y", static_rotation_y);
}

}  // namespace moat
