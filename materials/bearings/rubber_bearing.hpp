// Formulas of elastomeric bearings: critical load, vertical stiffness, shear strains.
#pragma once

#include <algorithm>

#include "base/check.hpp"

namespace moat {

/// The rules from which a formula of the shear strain in rubber comes.
enum class StrainFormula {
  mceer,      ///< AASHTO Guide Specifications for Seismic Isolation Design, and MCEER-11-0004
  en_15129,   ///< EN 15129, anti-seismic devices
  en_1337_3,  ///< EN 1337-3, elastomeric bearings
};

/// A bearing of n equal layers of rubber between steel plates, round or rectangular.
///
///         N, d ->
///      ____|______
///     |===========|  } t       A    area of the rubber, in plan
///     |===========|            S    shape factor, A/(t perimeter)
///     |===========|  T_r = n t A_r  area of the upper end over the lower end, displaced by d
///     `-----------`
///      diameter, or width_x by width_y
///
/// Compression is positive, and rubber counts as incompressible: E_c = 6 G S^2 of a circle, 6.73 G S^2 of a rectangle.
/// The second is that of a square; with sides of 1 to 2 it is 9 % too large, and E_r = E_c/3 likewise. A lead core
/// counts as rubber: with a fifth of the diameter it is 4 % of A.
///
/// Sources: Constantinou, Kalpakidis, Filiatrault & Ecker Lay (2011), MCEER-11-0004; Warn & Whittaker (2006) for the
/// displaced bearing; the area, E_r and P_cr are as in LeadRubberX of OpenSees. Clauses of AASHTO, EN 15129 and
/// EN 1337-3 are recalled, not read: compare them with the edition that governs your project.
struct RubberBearing {
  /// D > 0 m, of a round bearing; or give both widths.
  Length diameter{};
  /// b_x, b_y > 0 m, of a rectangular bearing; the longer side is at most twice the shorter one.
  Length width_x{}, width_y{};
  /// t > 0 m, of one layer of rubber.
  Required<Length> layer_thickness;
  /// T_r >= t, m, of all layers.
  Required<Length> rubber_thickness;
  /// G > 0 Pa.
  Required<Modulus> shear_modulus;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const;

  [[nodiscard]] bool is_round() const { return diameter.si() != 0.0; }  ///< A circle in plan.
  [[nodiscard]] Area area() const;                                      ///< A
  [[nodiscard]] double shape_factor() const;                            ///< S
  [[nodiscard]] Modulus compression_modulus() const;                    ///< E_c

  /// A_r/A, from 1 at rest to 0. Circle: (delta - sin delta)/pi with delta = 2 arccos(d/D); rectangle:
  /// (1 - |d_x|/b_x)(1 - |d_y|/b_y).
  [[nodiscard]] double overlap(Length d_x, Length d_y = {}) const;

  /// P_cr0 = sqrt(P_E G A_s): P_E = pi^2 E_r I_s/h^2, A_s = A h/T_r, I_s = I h/T_r about the weaker axis; h cancels.
  /// Haringx's column with P_E much above G A_s. 0.218 G D^4/(t T_r) of a circle.
  [[nodiscard]] Force critical_load() const;
  /// P_cr(d)/P_cr0 = max(A_r/A, 0.2): a fifth remains at any displacement (Warn & Whittaker 2006).
  [[nodiscard]] static double critical_share(double overlap) { return std::max(overlap, 0.2); }
  [[nodiscard]] Force critical_load(Length d_x, Length d_y = {}) const;  ///< P_cr(d)
  /// The buckling load of EN 15129 at rest, lambda G A a' S/T_r: lambda = 1.1 and a' = D of a circle, 1.3 and the
  /// shorter side of a rectangle.
  [[nodiscard]] Force buckling_load_en_15129() const;
  /// a' of EN 15129: the diameter, or the shorter side.
  [[nodiscard]] Length smallest_width() const;

  /// K_v(d) = E_c A/T_r/(1 + (3/pi^2)(d/r_g)^2), r_g the radius of gyration of A along d (Warn & Whittaker 2006).
  [[nodiscard]] Stiffness vertical_stiffness(Length d_x = {}, Length d_y = {}) const;

  /// d/T_r
  [[nodiscard]] double strain_by_shear(Length d_x, Length d_y = {}) const;
  /// The shear strain by N over A_r = overlap * A, with 0 < overlap <= 1; 0 in tension.
  ///
  ///     mceer      N/(A_r G S)                  EN 1337-3    1.5 N/(A_r G S)
  ///     EN 15129   6 S N/(A_r E_c'),   E_c' = 3 G (1 + 2 S^2)
  [[nodiscard]] double strain_by_compression(StrainFormula formula, Force compression, double overlap = 1.0) const;
  /// The shear strain by rotations >= 0 rad of one end against the other, theta_x about the y axis, which bends b_x,
  /// and theta_y:
  ///
  ///     mceer      D_r (b_x^2 theta_x + b_y^2 theta_y)/(t T_r),   D_r = 0.375 of a circle, 0.5 of a rectangle
  ///     both EN    (b_x^2 theta_x + b_y^2 theta_y) t/(2 sum t^3)
  [[nodiscard]] double strain_by_rotation(StrainFormula formula, Angle theta_x, Angle theta_y = {}) const;
};

}  // namespace moat
