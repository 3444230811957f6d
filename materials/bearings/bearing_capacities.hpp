// The load, deformation and speed that bearings and dampers can bear.
#pragma once

#include <optional>

#include "materials/bearings/rubber_bearing.hpp"

namespace moat {

/// Rules that give limits where a capacity is not given, and choose formulas of strain.
enum class CheckRules {
  none,    ///< no limits: demands are shown, and judged against given capacities only
  aashto,  ///< AASHTO Guide Specifications for Seismic Isolation Design, with MCEER-11-0004 for stability
  en,      ///< EN 15129, and EN 1337-3 for strain at rest
  asce,    ///< ASCE 7-16: stability and tension
};

/// Geometry and capacities of one bearing or damper. Everything may be left out: a check without its capacity is
/// reported as not judged.
///
///     {.rubber = RubberBearing{...}, .displacement_capacity = 0.5 * m}       a rubber bearing
///     {.slider_area = 0.12 * m_2, .displacement_capacity = 0.6 * m, .pressure_capacity = 60 * MPa}
///     {.stroke = 0.5 * m, .speed_capacity = 1.2 * m / s, .force_capacity = 1 * MN}       a damper
struct BearingCapacities {
  std::optional<RubberBearing> rubber{};  ///< Gives the checks of strain, stability and tension of rubber.
  std::optional<Area> slider_area{};      ///< > 0 m^2, of contact; gives the checks of pressure.

  std::optional<Length> displacement_capacity{};   ///< > 0 m, in any direction.
  std::optional<Length> stop{};                    ///< > 0 m, the way to a stop.
  std::optional<Length> stroke{};                  ///< > 0 m, of dampers, to each side.
  std::optional<Dimensionless> shear_capacity{};   ///< > 0, shear strain by shear alone.
  std::optional<Dimensionless> strain_capacity{};  ///< > 0, sum of shear strains; EN with a partial factor: 7/gamma_m.
  std::optional<Force> tension_capacity{};         ///< > 0 N.
  std::optional<Modulus> pressure_capacity{};      ///< > 0 Pa, of sliders.
  std::optional<Speed> speed_capacity{};           ///< > 0 m/s, of sliders and dampers.
  /// > 0 W/m^2: pressure times speed of sliders.
  std::optional<Quantity<1, 0, -3>> pressure_speed_capacity{};
  std::optional<Force> force_capacity{};  ///< > 0 N, of dampers.

  /// >= 0 m: of creep, shrinkage and temperature, for the sums of strains.
  Length static_displacement{};
  /// >= 0 rad: of one end against the other about the y and the x axis, for the sums of strains.
  Angle static_rotation_x{}, static_rotation_y{};

  /// Throws InputError for a value outside its range.
  void check(const Check& check) const;
};

}  // namespace moat
