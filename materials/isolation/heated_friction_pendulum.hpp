// Friction pendulum whose friction depends on pressure, temperature and speed.
#pragma once

#include "materials/carried_weight.hpp"
#include "materials/heated_under_weight.hpp"

namespace moat {

/// Friction pendulum whose friction depends on pressure, temperature and speed: F and R as in FrictionPendulum.
///
/// Everything is for one bearing: give a layer by Isolator::count. Reports `surface_temperature` [degC].
struct HeatedFrictionPendulum {
  static constexpr std::string_view name = "HeatedFrictionPendulum";
  static constexpr std::string_view formula = "pendulum, mu falls with pressure and temperature, rises with speed";
  static constexpr std::string_view assumption =
      "The weight is constant: neither vertical motion nor overturning acts. The surface counts as a parabola.";

  /// R > 0 m, effective.
  Required<Length> radius;
  /// Friction of its surface.
  Required<PressureTemperatureVelocity> friction;
  /// u_y > 0 m.
  Length yield_displacement = 1.0 * units::mm;
  /// N > 0 N, of this bearing; its share of the building's if left out.
  Force weight{};

  /// The bearing that MASTODON's authors compare with OpenSees.
  static HeatedFrictionPendulum typical() {
    using namespace units;
    return {.radius = 2.2352 * m,
            .friction = PressureTemperatureVelocity{
                .reference_coefficient = 0.06, .reference_pressure = 50 * MN / (m * m), .slider_radius = 20 * cm}};
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
  [[nodiscard]] HeatedSlidingIsolator carrying(Force load) const {
    const double normal = load.si();
    HeatedSlidingIsolator law{
        .restoring_stiffness = normal / radius.si(), .normal_force = normal, .friction = friction};
    law.elastic_stiffness = friction.value().reference_coefficient * friction.value().pressure_factor(law.pressure()) *
                            normal / yield_displacement.si();
    return law;
  }
  /// The law under a weight that changes, with this one at rest.
  [[nodiscard]] HeatedUnderWeight under_changing_weight(Force static_weight) const { return {carrying(static_weight)}; }
};

}  // namespace moat
