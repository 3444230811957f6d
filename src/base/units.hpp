// Units to write quantities with: `10 * cm`, `1.93 * MN`, `2.95e9 * N / m_3_2`, `0.4 * g`.
#pragma once

#include <numbers>

#include "base/quantity.hpp"

namespace moat {

/// Standard acceleration of gravity, m/s^2.
inline constexpr double standard_gravity = 9.80665;

/// Brought into a script by `using namespace moat::units;`.
namespace units {

using std::numbers::pi;

/// Metre, millimetre, centimetre, kilometre.
inline constexpr Length m{1.0}, mm{1e-3}, cm{1e-2}, km{1e3};
/// Second, millisecond, minute.
inline constexpr Time s{1.0}, ms{1e-3}, minute{60.0};
/// Kilogram, tonne of 1000 kg.
inline constexpr Mass kg{1.0}, tonne{1e3};
/// Newton and its multiples.
inline constexpr Force N{1.0}, kN{1e3}, MN{1e6}, GN{1e9};
/// Joule and its multiples.
inline constexpr Energy J{1.0}, kJ{1e3}, MJ{1e6};
/// Pascal and its multiples.
inline constexpr Modulus Pa{1.0}, kPa{1e3}, MPa{1e6}, GPa{1e9};
inline constexpr Frequency Hz{1.0};                 ///< Hertz, 1/s.
inline constexpr Acceleration g{standard_gravity};  ///< 9.80665 m/s^2.
/// Radian, degree.
inline constexpr double rad = 1.0, deg = pi / 180.0;
/// m^1.5: `N / m_3_2` is the unit of a Hertz stiffness.
inline constexpr Quantity<0, 3, 0> m_3_2{1.0};
/// Areas: m^2, cm^2, mm^2.
inline constexpr Area m_2{1.0}, cm_2{1e-4}, mm_2{1e-6};
/// m^3: `kg / m_3` is the unit of a density.
inline constexpr Quantity<0, 6, 0> m_3{1.0};
/// Second moments of areas: m^4, cm^4, mm^4.
inline constexpr SecondMoment m_4{1.0}, cm_4{1e-8}, mm_4{1e-12};

}  // namespace units
}  // namespace moat
