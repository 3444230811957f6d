// Elastic spectra of codes: ASCE 7, EN 1998-1, GB 50011.
#pragma once

#include <optional>

#include "base/quantity.hpp"
#include "base/required.hpp"
#include "motions/spectra/target_spectrum.hpp"

namespace moat {

/// The two-period spectrum of ASCE 7, 5 % damping:
///
///        S_a ^
///      S_DS  |   .------.              T_0 = 0.2 T_S,  T_S = S_D1/S_DS
///            |  /        \             S_DS (0.4 + 0.6 T/T_0)   to T_0
///            | /           `.          S_DS                     to T_S
///            |/               `-._     S_D1/T                   to T_L
///            +---+------+--------+-->  S_D1 T_L/T^2             beyond
///               T_0    T_S      T_L  T
///
/// Source: ASCE/SEI 7-22, chapter 11 (recalled, not read in the code; the branches are those of ASCE 7-10 in public
/// scripts). MCE_R is 1.5 times the design spectrum.
struct Asce7Spectrum {
  /// Design accelerations as fractions of g, at short periods and at 1 s: > 0, <= 10. S_D1/S_DS: from 0.05 to 3 s.
  Required<double> s_ds, s_d1;
  /// T_L of the map, > S_D1/S_DS; usually from 4 to 16 s.
  Required<Time> long_period;

  /// These throw InputError for values outside their ranges. There is no conversion: a script says which one it means.
  [[nodiscard]] TargetSpectrum design() const;
  [[nodiscard]] TargetSpectrum mce_r() const;  ///< 1.5 times design().
};

/// S_DS, S_D1 and T_L of a multi-period spectrum of ASCE 7-22, for example of read_target_spectrum():
///
///     S_MS = 0.9 max S_a from 0.2 to 5 s
///     S_M1 = max(0.9 max T S_a/1 s, S_a(1 s)), T from 1 to 2 s where v_s30 > 442 m/s, else to 5 s
///     S_DS = 2/3 S_MS, S_D1 = 2/3 S_M1; at the level of design S_a gives them at once
///
/// Spectra are read at their corners and every 1 ms between. Source: ASCE/SEI 7-22 21.4 (as in the news of the R
/// package newmark, not read in the code).
///
/// shear_wave_velocity: v_s30 > 0 m/s. long_period: T_L of the map. Throws InputError for a spectrum that does not
/// reach from 0.2 to 5 s, and for a shear wave velocity that is not positive.
[[nodiscard]] Asce7Spectrum asce_7_parameters(const TargetSpectrum& spectrum, SpectrumLevel level,
                                              Speed shear_wave_velocity, Time long_period);

/// Parameters of a spectrum of EN 1998-1, for national annexes.
struct En1998Shape {
  Required<double> soil_factor;  ///< S, > 0, <= 10.
  Required<Time> t_b, t_c, t_d;  ///< 0 < T_B < T_C < T_D <= 4 s.
};

/// The elastic spectrum of EN 1998-1:2004, 3.2.2.2, with the recommended values of both types (as in
/// ROB-Seismology/rshalib):
///
///     a_g S (1 + T/T_B (2.5 eta - 1))   to T_B
///     2.5 eta a_g S                     to T_C
///     2.5 eta a_g S T_C/T               to T_D
///     2.5 eta a_g S T_C T_D/T^2         to 4 s,   eta = sqrt(10/(5 + 100 damping_ratio)) >= 0.55
///
///     type 1   S     T_B  T_C  T_D      type 2   S     T_B  T_C  T_D
///     A        1.0   .15  .4   2.0      A        1.0   .05  .25  1.2
///     B        1.2   .15  .5   2.0      B        1.35  .05  .25  1.2
///     C        1.15  .20  .6   2.0      C        1.5   .10  .25  1.2
///     D        1.35  .20  .8   2.0      D        1.8   .10  .30  1.2
///     E        1.4   .15  .5   2.0      E        1.6   .05  .25  1.2
struct En1998Spectrum {
  /// a_g = gamma_I a_gR on rock, > 0, <= 2 g. Importance factors gamma_I are 0.8, 1.0, 1.2 and 1.4.
  Required<Acceleration> ground_acceleration;
  int type = 1;                        ///< 1 or 2.
  std::optional<char> ground{};        ///< 'A' to 'E'; may be left out with a shape, and where vertical.
  std::optional<En1998Shape> shape{};  ///< Instead of the recommended values.
  double damping_ratio = 0.05;         ///< >= 0, < 1
  /// 3.2.2.3: 0.9 a_g (type 2: 0.45), 3.0 for 2.5, no S, T_B, T_C, T_D of 0.05, 0.15 and 1.0 s.
  bool vertical = false;
  /// Goes on to 10 s by the informative annex A, which needs the ground (recalled, not read in the code). The last
  /// branch goes to T_E = 4.5 s (A), 5 s (B) or 6 s (C, D, E). Beyond it stands, with T_F = 10 s, the displacement
  /// 0.025 a_g S T_C T_D (2.5 eta + (T - T_E)/(T_F - T_E) (1 - 2.5 eta)).
  bool beyond_4_s = false;

  operator TargetSpectrum() const;  ///< Throws InputError for values outside their ranges.
};

/// The seismic influence coefficient of GB 50011-2010 (2016), 5.1.5, times g (as in a public module):
///
///     alpha_max (0.45 + (eta_2 - 0.45) T/0.1 s)             to 0.1 s
///     eta_2 alpha_max                                       to T_g
///     eta_2 alpha_max (T_g/T)^gamma                         to 5 T_g
///     alpha_max (eta_2 0.2^gamma - eta_1 (T - 5 T_g)/1 s)   to 6 s
///
/// gamma = 0.9 + (0.05 - z)/(0.3 + 6 z), eta_1 = 0.02 + (0.05 - z)/(4 + 32 z) >= 0, eta_2 = 1 + (0.05 - z)/(0.08 +
/// 1.6 z) >= 0.55 with the damping ratio z.
///
/// alpha_max of table 5.1.4-1 (the basic level is not in 5.1.4) and T_g in s of table 5.1.4-2, for rare earthquakes
/// 0.05 s longer (recalled, not read in the code):
///
///     intensity  6    7    7 (.15g)  8    8 (.30g)  9       group  I0   I1   II   III  IV
///     frequent  .04  .08  .12       .16  .24       .32      1     .20  .25  .35  .45  .65
///     basic     .12  .23  .34       .45  .68       .90      2     .25  .30  .40  .55  .75
///     rare      .28  .50  .72       .90  1.20     1.40      3     .30  .35  .45  .65  .90
struct Gb50011Spectrum {
  Required<double> alpha_max;            ///< > 0, <= 3.
  Required<Time> characteristic_period;  ///< T_g, > 0.1 s, <= 1.2 s.
  double damping_ratio = 0.05;           ///< >= 0, < 1
  /// The power of T_g/T goes on to 6 s, for isolated buildings (GB/T 51408, recalled, not read in the code).
  bool isolation = false;

  operator TargetSpectrum() const;  ///< Throws InputError for values outside their ranges.
};

}  // namespace moat
