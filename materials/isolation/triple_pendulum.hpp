// Friction pendulum with an inner slider between two outer surfaces.
#pragma once

#include <algorithm>

#include "materials/carried_weight.hpp"
#include "materials/series_under_weight.hpp"

namespace moat {

/// Triple pendulum: an inner slider with two equal surfaces between two outer ones. It stiffens in steps:
///
///     F ^             .-- V      I    inner surfaces alone       W/(2 L_1)
///       |          .-'  IV       II   with the lower outer       W/(L_1 + L_2)
///       |       .-'  III         III  both outer                 W/(L_2 + L_3)
///       |    .-'  II             IV   the lower one at its stop  W/(L_1 + L_3)
///       |  .' I                  V    both at their stops        W/(2 L_1), until one inner surface is at its stop
///     --+--------------> u       VI   the other inner one alone  W/L_1, until u = 2 d_1 + d_2 + d_3
///
/// Where d_3/L_3 + mu_3 < d_2/L_2 + mu_2 the upper one stops first, and IV has W/(L_1 + L_2). An inner surface, which
/// the outer one on its side tilts, stops at F = W (d_1/L_1 + d_out/L_out + mu_1).
///
/// Three sliders in series reproduce it exactly where mu_1 < mu_2 <= mu_3, d_2 >= (mu_3 - mu_2) L_2 and
/// d_1 >= (mu_3 - mu_1) L_1, that is where all surfaces slide before one is at its stop; others are refused. Beyond all
/// stops a branch has ten times its elastic stiffness. Friction does not depend on speed. L = R - h are effective
/// radii, d = d_nominal L/R the true capacities. Source: Fenz & Constantinou (2008).
struct TriplePendulum {
  static constexpr std::string_view name = "TriplePendulum";
  static constexpr std::string_view formula = "three sliders in series, with stops";
  static constexpr std::string_view assumption = "The weight is constant, and friction does not depend on speed.";

  /// L_1 > 0 m, of both inner surfaces; L_2, L_3 > L_1, of the lower and upper outer surface.
  Required<Length> inner_radius;
  Required<Length> lower_radius;  ///< L_2
  Required<Length> upper_radius;  ///< L_3
  /// 0 < mu_1 < mu_2 <= mu_3 <= 0.3.
  Required<double> inner_friction;
  Required<double> lower_friction;  ///< mu_2
  Required<double> upper_friction;  ///< mu_3
  /// d_1, d_2, d_3 > 0 m.
  Required<Length> inner_capacity;
  Required<Length> lower_capacity;  ///< d_2
  Required<Length> upper_capacity;  ///< d_3
  /// u_y > 0 m: elastic move before the inner surfaces slide.
  Length yield_displacement = 1.0 * units::mm;
  /// W > 0 N; that of the building if left out.
  Force weight{};

  /// Configuration A of Kim & Constantinou (2023).
  static TriplePendulum typical() {
    using namespace units;
    return {.inner_radius = 0.3937 * m,
            .lower_radius = 3.7465 * m,
            .upper_radius = 3.7465 * m,
            .inner_friction = 0.01,
            .lower_friction = 0.04,
            .upper_friction = 0.08,
            .inner_capacity = 0.0716 * m,
            .lower_capacity = 0.5043 * m,
            .upper_capacity = 0.5043 * m};
  }

  void check(const Check& check) const {
    check.positive("inner_radius", inner_radius);
    const auto larger = [&](std::string_view field, Length radius) {
      check.that(radius > inner_radius.value(), field, radius.si(), "m",
                 "above inner_radius = " + to_text(inner_radius.si()) + " m");
    };
    larger("lower_radius", lower_radius);
    larger("upper_radius", upper_radius);
    check.that(inner_friction > 0.0 && inner_friction < lower_friction, "inner_friction", inner_friction, "1",
               "> 0 and below lower_friction = " + to_text(lower_friction),
               "Three sliders in series need friction that rises from inside to outside.");
    check.that(lower_friction <= upper_friction, "lower_friction", lower_friction, "1",
               "at most upper_friction = " + to_text(upper_friction),
               "The surface with less friction is the lower one.");
    check.above_up_to("upper_friction", upper_friction, 0.0, 0.3, "1");
    const double least_inner = (upper_friction - inner_friction) * inner_radius.si();
    check.that(inner_capacity.si() > 0.0 && inner_capacity.si() >= least_inner, "inner_capacity", inner_capacity.si(),
               "m", ">= (upper_friction - inner_friction) inner_radius = " + to_text(least_inner) + " m",
               "Else an inner surface reaches its stop before the upper one slides, which this model does not cover.");
    const double least = (upper_friction - lower_friction) * lower_radius.si();
    check.that(lower_capacity.si() > 0.0 && lower_capacity.si() >= least, "lower_capacity", lower_capacity.si(), "m",
               ">= (upper_friction - lower_friction) lower_radius = " + to_text(least) + " m",
               "Else the lower surface reaches its stop before the upper one slides, which this model does not cover.");
    check.positive("upper_capacity", upper_capacity);
    check.positive("yield_displacement", yield_displacement);
    check.not_negative("weight", weight);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"inner_radius", inner_radius.si(), "m"},     {"lower_radius", lower_radius.si(), "m"},
            {"upper_radius", upper_radius.si(), "m"},     {"inner_friction", inner_friction, "1"},
            {"lower_friction", lower_friction, "1"},      {"upper_friction", upper_friction, "1"},
            {"inner_capacity", inner_capacity.si(), "m"}, {"lower_capacity", lower_capacity.si(), "m"},
            {"upper_capacity", upper_capacity.si(), "m"}, {"yield_displacement", yield_displacement.si(), "m"}};
  }
  [[nodiscard]] SeriesOfSliders carrying(Force load) const {
    const double normal = load.si(), elastic = 3.0 * inner_friction * normal / yield_displacement.si();
    const double inner = inner_radius.si(), lower = lower_radius.si(), upper = upper_radius.si();
    SeriesOfSliders law{.count = 3, .elastic_stiffness = elastic, .stop_stiffness = 10.0 * elastic};
    // Each inner surface stops at the sum of its own capacity and the share by which the outer one tilts it.
    const double beside_lower = inner_capacity.si() + inner / lower * lower_capacity.si(),
                 beside_upper = inner_capacity.si() + inner / upper * upper_capacity.si();
    law.branches[0] = {.stiffness = normal / (2.0 * inner),
                       .friction = inner_friction * normal,
                       .capacity = beside_lower + beside_upper};
    if (beside_lower != beside_upper) law.branches[0].first_stop = 2.0 * std::min(beside_lower, beside_upper);
    law.branches[1] = {.stiffness = normal / (lower - inner),
                       .friction = lower_friction * normal,
                       .capacity = lower_capacity.si() * (1.0 - inner / lower)};
    law.branches[2] = {.stiffness = normal / (upper - inner),
                       .friction = upper_friction * normal,
                       .capacity = upper_capacity.si() * (1.0 - inner / upper)};
    return law;
  }
  /// The law under a weight that changes, with this one at rest.
  [[nodiscard]] SeriesUnderWeight under_changing_weight(Force static_weight) const {
    return {carrying(static_weight), static_weight.si()};
  }
};

}  // namespace moat
