// Rayleigh damping of a superstructure.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "base/quantity.hpp"

namespace moat {

/// Rayleigh damping of a building held at its base, C = a0 M + a1 K:
///
///     RayleighDamping{.ratio = 0.05}                                        in its first two modes
///     RayleighDamping{.ratio = 0.05, .periods = {0.9 * s, 0.1 * s}}
///     RayleighDamping{.ratios = {0.05, 0.03}, .periods = {0.9 * s, 0.1 * s}}
///     RayleighDamping{.a0 = 0.3 / s, .a1 = 2 * ms}
///
/// a0 acts on motion relative to the base; the alphaM of OpenSees acts on motion relative to the ground.
struct RayleighDamping {
  /// 0 <= ratio < 1; 0.05 is 5 % of critical.
  double ratio = 0.0;
  /// 0 <= ratio < 1 at each of `periods`, in place of `ratio`.
  std::array<double, 2> ratios{};
  /// > 0 s, different; those of the first two modes if left out.
  std::array<Time, 2> periods{};
  /// >= 0 1/s; together with a1, in place of ratios and periods.
  Frequency a0{};
  Time a1{};  ///< >= 0 s
};

/// C = mass_factor M + stiffness_factor K.
struct RayleighFactors {
  double mass_factor = 0.0;       ///< 1/s
  double stiffness_factor = 0.0;  ///< s
};

/// Factors that give `ratio` at two angular frequencies w1, w2 (1/s):
/// mass_factor = 2 ratio w1 w2 / (w1 + w2), stiffness_factor = 2 ratio / (w1 + w2).
/// Throws InputError for a ratio outside [0, 1) or a frequency that is not positive.
RayleighFactors rayleigh_factors(double ratio, double first_angular_frequency, double second_angular_frequency);

/// The factors of damping that is given by periods, or by a0 and a1; none where it is one ratio in modes that are not
/// known here. Ratios z1, z2 at w = 2 pi / T:
///
///     a1 = 2 (z1 w1 - z2 w2)/(w1^2 - w2^2)    a0 = 2 z1 w1 - a1 w1^2
///
/// Throws InputError for a ratio outside [0, 1), periods that are equal or not positive, a negative factor, and for
/// fields that exclude each other.
std::optional<RayleighFactors> given_factors(const RayleighDamping& damping);

/// Factors for a chain of storeys held at its foot: masses (kg) and stiffnesses (N/m) from the lowest
/// storey up. One storey has one mode: then only the stiffness part, 2 ratio / w1.
RayleighFactors rayleigh_factors_of_chain(double ratio, std::span<const Mass> masses,
                                          std::span<const Stiffness> stiffnesses);

}  // namespace moat
