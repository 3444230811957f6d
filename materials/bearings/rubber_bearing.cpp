#include "materials/bearings/rubber_bearing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moat {
namespace {

constexpr double pi = std::numbers::pi;

double squared(double value) { return value * value; }

// Square of the radius of gyration of a rectangle's side or a circle's diameter, m^2.
double gyration_squared(const RubberBearing& bearing, Length width) {
  return squared(width.si()) / (bearing.is_round() ? 16.0 : 12.0);
}

}  // namespace

void RubberBearing::check(const Check& check) const {
  const bool has_widths = width_x.si() != 0.0 || width_y.si() != 0.0;
  check.that(is_round() != has_widths, "diameter and widths are both given, or neither.",
             "Give diameter, or width_x and width_y.");
  if (is_round()) {
    check.positive("diameter", diameter);
  } else {
    check.positive("width_x", width_x);
    check.positive("width_y", width_y);
    const double slender = std::max(width_x, width_y) / smallest_width();
    check.that(slender <= 2.0, "ratio of widths", slender, "1", "<= 2",
               "The formulas of the rubber are those of a square.");
  }
  check.positive("layer_thickness", layer_thickness);
  check.positive("rubber_thickness", rubber_thickness);
  check.that(rubber_thickness.value() >= layer_thickness.value(), "rubber_thickness", rubber_thickness.si(), "m",
             ">= layer_thickness", "It is the sum of all layers.");
  check.positive("shear_modulus", shear_modulus);
}

Length RubberBearing::smallest_width() const { return is_round() ? diameter : std::min(width_x, width_y); }

Area RubberBearing::area() const { return is_round() ? 0.25 * pi * diameter * diameter : width_x * width_y; }

double RubberBearing::shape_factor() const {
  const Length perimeter = is_round() ? pi * diameter : 2.0 * (width_x + width_y);
  return area() / (perimeter * layer_thickness.value());
}

Modulus RubberBearing::compression_modulus() const {
  return (is_round() ? 6.0 : 6.73) * squared(shape_factor()) * shear_modulus.value();
}

double RubberBearing::overlap(Length d_x, Length d_y) const {
  if (!is_round()) return std::max(0.0, 1.0 - std::abs(d_x / width_x)) * std::max(0.0, 1.0 - std::abs(d_y / width_y));
  const double delta = 2.0 * std::acos(std::min(1.0, std::hypot(d_x.si(), d_y.si()) / diameter.si()));
  return (delta - std::sin(delta)) / pi;
}

Force RubberBearing::critical_load() const {
  const Area gyration{gyration_squared(*this, smallest_width())};
  return pi * area() / rubber_thickness.value() * sqrt(compression_modulus() / 3.0 * gyration * shear_modulus.value());
}

Force RubberBearing::critical_load(Length d_x, Length d_y) const {
  return critical_share(overlap(d_x, d_y)) * critical_load();
}

Force RubberBearing::buckling_load_en_15129() const {
  return (is_round() ? 1.1 : 1.3) * shape_factor() * (smallest_width() / rubber_thickness.value()) *
         (shear_modulus.value() * area());
}

Stiffness RubberBearing::vertical_stiffness(Length d_x, Length d_y) const {
  const double moved = squared(d_x.si()) / gyration_squared(*this, is_round() ? diameter : width_x) +
                       squared(d_y.si()) / gyration_squared(*this, is_round() ? diameter : width_y);
  return compression_modulus() * area() / rubber_thickness.value() / (1.0 + 3.0 / squared(pi) * moved);
}

double RubberBearing::strain_by_shear(Length d_x, Length d_y) const {
  return std::hypot(d_x.si(), d_y.si()) / rubber_thickness.si();
}

double RubberBearing::strain_by_compression(StrainFormula formula, Force compression, double overlap) const {
  const double shape = shape_factor(),
               pressure = std::max(compression, Force{}) / (overlap * area() * shear_modulus.value());
  if (formula == StrainFormula::en_15129) return 2.0 * shape * pressure / (1.0 + 2.0 * squared(shape));
  return (formula == StrainFormula::mceer ? 1.0 : 1.5) * pressure / shape;
}

double RubberBearing::strain_by_rotation(StrainFormula formula, Angle theta_x, Angle theta_y) const {
  const double bent = is_round() ? squared(diameter.si()) * (theta_x + theta_y)
                                 : squared(width_x.si()) * theta_x + squared(width_y.si()) * theta_y;
  const double factor = formula == StrainFormula::mceer && is_round() ? 0.375 : 0.5;
  return factor * bent / (layer_thickness.si() * rubber_thickness.si());
}

}  // namespace moat
