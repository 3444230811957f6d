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

inline constexpr Length m{1.0}, mm{1e-3}, cm{1e-2}, km{1e3};
inline constexpr Time s{1.0}, ms{1e-3}, minute{60.0};
inline constexpr Mass kg{1.0}, tonne{1e3};
inline constexpr Force N{1.0}, kN{1e3}, MN{1e6}, GN{1e9};
inline constexpr Energy J{1.0}, kJ{1e3}, MJ{1e6};
inline constexpr Frequency Hz{1.0};
inline constexpr Acceleration g{standard_gravity};
inline constexpr double rad = 1.0, deg = pi / 180.0;
/// m^1.5: `N / m_3_2` is the unit of a Hertz stiffness.
inline constexpr Quantity<0, 3, 0> m_3_2{1.0};

}  // namespace units
}  // namespace moat
