// Rayleigh damping of a superstructure.
#pragma once

#include <span>

#include "base/quantity.hpp"

namespace moat {

/// One damping ratio in the first two modes of the building held at its base.
struct RayleighDamping {
  /// 0 <= ratio < 1; 0.05 is 5 % of critical.
  double ratio = 0.0;
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

/// Factors for a chain of storeys held at its foot: masses (kg) and stiffnesses (N/m) from the lowest
/// storey up. One storey has one mode: then only the stiffness part, 2 ratio / w1.
RayleighFactors rayleigh_factors_of_chain(double ratio, std::span<const Mass> masses,
                                          std::span<const Stiffness> stiffnesses);

}  // namespace moat
