// Friction pendulum with one sliding surface.
#pragma once

#include <cmath>

#include "materials/carried_weight.hpp"
#include "materials/sliding_under_weight.hpp"

namespace moat {

/// Friction pendulum: a slider on a concave surface.
///
///      [ base ] -> u          F = (W/R) d + q,    |q| <= mu(|v|) W
///     -----(_)-----           elastic with mu W/u_y before it slides (materials/sliding_isolator.hpp)
///      \_________/            period 2 pi sqrt(R/g), for every mass
///
/// R is the effective radius, that of the surface less the height of the slider. The surface counts as a parabola: at
/// d/R = 0.045 the restoring force is 0.1 % too small. Small stiffness at very small moves stands for the liner. The
/// weight is constant, unless the building has AxialForces. Sources: Zayas, Low & Mahin (1987); Constantinou,
/// Mokha & Reinhorn (1990). Radii of one maker: 1.55, 2.235, 3.96, 6.05 m.
struct FrictionPendulum {
  static constexpr std::string_view name = "FrictionPendulum";
  static constexpr std::string_view formula = "F = (W/R) d + q, abs(q) <= mu W; stick and slip located";
  static constexpr std::string_view assumption = "The surface counts as a parabola.";

  /// R > 0 m.
  Required<Length> radius;
  /// A number, or a model with speed and pressure (materials/friction/friction_models.hpp).
  Required<Friction> friction;
  /// u_y > 0 m: elastic move before it slides at high speed.
  Length yield_displacement = 1.0 * units::mm;
  /// W > 0 N; that of the building if left out.
  Force weight{};

  /// PTFE-type composite on stainless steel.
  static FrictionPendulum typical() {
    using namespace units;
    return {.radius = 3 * m, .friction = VelocityDependent{.slow = 0.03, .fast = 0.06, .rate = 50 * s / m}};
  }

  void check(const Check& check) const {
    check.positive("radius", radius);
    friction.value().check(check);
    check.positive("yield_displacement", yield_displacement);
    check.not_negative("weight", weight);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    std::vector<Parameter> list{{"radius", radius.si(), "m"}};
    for (const Parameter& each : friction.value().parameters()) list.push_back(each);
    list.push_back({"yield_displacement", yield_displacement.si(), "m"});
    return list;
  }
  /// The law under a weight that changes; `load` > 0 N is that at rest.
  [[nodiscard]] SlidingUnderWeight under_changing_weight(Force load) const {
    const double normal = load.si();
    return {.radius = radius.si(),
            .restoring_stiffness = 0.0,
            .elastic_stiffness = friction.value().fast(normal) * normal / yield_displacement.si(),
            .static_weight = normal,
            .friction = friction};
  }
  [[nodiscard]] SlidingIsolator carrying(Force load) const {
    const double normal = load.si();
    return {.restoring_stiffness = normal / radius.si(),
            .elastic_stiffness = friction.value().fast(normal) * normal / yield_displacement.si(),
            .normal_force = normal,
            .friction = friction};
  }
};

}  // namespace moat
