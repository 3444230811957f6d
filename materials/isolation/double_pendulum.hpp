// Friction pendulum with two sliding surfaces.
#pragma once

#include "materials/carried_weight.hpp"
#include "materials/series_under_weight.hpp"

namespace moat {

/// Double pendulum: two concave surfaces, one above the slider and one below. The surface with less friction slides
/// first, at mu_1 W; the other joins at mu_2 W, u = (mu_2 - mu_1) L_1; then F = W u/(L_1 + L_2) + a mean friction.
///
/// Friction does not depend on speed. Source: Fenz & Constantinou (2006).
struct DoublePendulum {
  static constexpr std::string_view name = "DoublePendulum";
  static constexpr std::string_view formula = "two sliders in series";
  static constexpr std::string_view assumption = "The weight is constant, and friction does not depend on speed.";

  /// L_1, L_2 > 0 m: effective radii.
  Required<Length> first_radius;
  Required<Length> second_radius;  ///< L_2
  /// 0 < mu_1 <= mu_2 <= 0.3.
  Required<double> first_friction;
  Required<double> second_friction;  ///< mu_2
  /// u_y > 0 m: elastic move of the first surface before it slides.
  Length yield_displacement = 1.0 * units::mm;
  /// W > 0 N; that of the building if left out.
  Force weight{};

  static DoublePendulum typical() {
    using namespace units;
    return {.first_radius = 2 * m, .second_radius = 2 * m, .first_friction = 0.03, .second_friction = 0.07};
  }

  void check(const Check& check) const {
    check.positive("first_radius", first_radius);
    check.positive("second_radius", second_radius);
    check.above_up_to("first_friction", first_friction, 0.0, second_friction, "1",
                      "The surface with less friction is the first.");
    check.above_up_to("second_friction", second_friction, 0.0, 0.3, "1");
    check.positive("yield_displacement", yield_displacement);
    check.not_negative("weight", weight);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"first_radius", first_radius.si(), "m"},
            {"second_radius", second_radius.si(), "m"},
            {"first_friction", first_friction, "1"},
            {"second_friction", second_friction, "1"},
            {"yield_displacement", yield_displacement.si(), "m"}};
  }
  [[nodiscard]] SeriesOfSliders carrying(Force load) const {
    const double normal = load.si(), elastic = 2.0 * first_friction * normal / yield_displacement.si();
    SeriesOfSliders law{.count = 2, .elastic_stiffness = elastic, .stop_stiffness = 10.0 * elastic};
    law.branches[0] = {.stiffness = normal / first_radius.si(), .friction = first_friction * normal};
    law.branches[1] = {.stiffness = normal / second_radius.si(), .friction = second_friction * normal};
    return law;
  }
  /// The law under a weight that changes, with this one at rest.
  [[nodiscard]] SeriesUnderWeight under_changing_weight(Force static_weight) const {
    return {carrying(static_weight), static_weight.si()};
  }
};

}  // namespace moat
