// Elastic response spectra of two components of a motion.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "motions/plan_motion.hpp"

namespace moat {

/// One of the spectra of a pair. `srss_over_1_3` is SRSS/1.3 (EN 1998-2, recalled, not read in the code);
/// `each_component` are two, `first` and `second`.
enum class PairSpectrum { first, second, srss, srss_over_1_3, geometric_mean, rotd50, rotd100, each_component };

/// "RotD100".
[[nodiscard]] std::string name_of(PairSpectrum spectrum);

/// Pseudo-accelerations of a pair, one entry per period, m/s^2. With u_x, u_y of an oscillator under each component:
///
///     component   w^2 max |u_x|, w^2 max |u_y|,   w = 2 pi / T
///     RotD(b)     w^2 max |u_x cos b + u_y sin b|,   b = 0, 1, ... 179 deg
///
/// Components, their SRSS and their geometric mean depend on the axes, which are those of the model: they are the
/// components of the record as given where its `incidence` is 0. RotD50 and RotD100 do not depend on the axes (Boore
/// 2010). RotD100 <= SRSS <= sqrt(2) RotD100. Steps of 1 degree miss at most 3.8e-5 of the largest direction.
struct PairSpectra {
  double damping_ratio = 0.0;          ///< Share of critical damping.
  std::vector<double> period;          ///< T, s
  std::vector<double> first, second;   ///< along x and y of the model
  std::vector<double> srss;            ///< sqrt(first^2 + second^2): the peaks come at different times
  std::vector<double> geometric_mean;  ///< sqrt(first * second)
  std::vector<double> rotd50;          ///< median over the directions: the mean of the 90th and 91st value of 180
  std::vector<double> rotd100;         ///< largest over the directions

  /// Returns one of them; each_component has the second component behind the first.
  [[nodiscard]] std::vector<double> of(PairSpectrum spectrum) const;
};

/// The spectra of a pair. Periods and damping_ratio as in response_spectrum(); the accuracy is 1e-5 of each value.
/// Throws InputError outside their ranges and where the components do not fit together.
[[nodiscard]] PairSpectra pair_spectra(const PlanMotion& motion, std::span<const Time> periods,
                                       double damping_ratio = 0.05);

/// Periods in equal ratios, both ends included, 0 < shortest < longest: as many as make the ratio 1.02 or a little
/// less.
[[nodiscard]] std::vector<Time> periods_between(Time shortest, Time longest);

}  // namespace moat
