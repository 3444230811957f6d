#include "model/diaphragm.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace moat {

namespace {

// The centre of mass of a body lies in every convex shape around it.
void check_place_of_mass(const Check& check, const Diaphragm& diaphragm) {
  const auto check_axis = [&](const char* field, Length PlanPosition::*axis) {
    const auto [lowest, highest] = std::ranges::minmax(diaphragm.outline.corners, {}, axis);
    check.between(field, (diaphragm.centre_of_mass.*axis).si(), (lowest.*axis).si() - same_place,
                  (highest.*axis).si() + same_place, "m",
                  "It lies within the outline; both are in coordinates of the whole model.");
  };
  check_axis("centre_of_mass.x", &PlanPosition::x);
  check_axis("centre_of_mass.y", &PlanPosition::y);
}

}  // namespace

double checked_rotary_inertia(const Diaphragm& diaphragm) {
  const Check check{"Diaphragm", diaphragm.name};
  check.that(!diaphragm.name.empty(), "a diaphragm has no name.", "Give .name: results are listed under it.");
  check.positive("mass", diaphragm.mass);
  check.finite("centre_of_mass.x", diaphragm.centre_of_mass.x);
  check.finite("centre_of_mass.y", diaphragm.centre_of_mass.y);
  const bool has_size = diaphragm.size.x != Length{} || diaphragm.size.y != Length{};
  if (has_size) {
    check.positive("size.x", diaphragm.size.x);
    check.positive("size.y", diaphragm.size.y);
  }
  if (!diaphragm.outline.empty()) {
    diaphragm.outline.check(check, "outline");
    check_place_of_mass(check, diaphragm);
  }
  const double mass = diaphragm.mass.si();
  double inertia = diaphragm.rotary_inertia.si();
  if (inertia == 0.0 && has_size) {
    const double x = diaphragm.size.x.si(), y = diaphragm.size.y.si();
    inertia = mass * (x * x + y * y) / 12.0;
  } else if (inertia == 0.0 && !diaphragm.outline.empty()) {
    inertia = mass * diaphragm.outline.gyration_squared();
  }
  check.positive("rotary_inertia", inertia, "kg m^2", "Give .rotary_inertia, or .size or .outline of a uniform floor.");
  double farthest = 0.0;
  if (!diaphragm.outline.empty()) {
    for (std::size_t i = 0; i < diaphragm.outline.size(); ++i)
      farthest = std::max(farthest, length(diaphragm.outline.corner(i) - diaphragm.centre_of_mass.si()));
  } else if (has_size) {
    farthest = 0.5 * std::hypot(diaphragm.size.x.si(), diaphragm.size.y.si());
  }
  if (farthest > 0.0)
    check.that(inertia <= mass * farthest * farthest, "rotary_inertia", inertia, "kg m^2",
               "at most mass times the squared distance of the farthest corner from the centre of mass, " +
                   to_text(mass * farthest * farthest) + " kg m^2",
               "Take it about the centre of mass: mass * (Lx^2 + Ly^2)/12 for a uniform rectangle.");
  return inertia;
}

}  // namespace moat
