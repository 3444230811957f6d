// Whether isolators come back: the displacement at which friction may hold them, and the rules of restoring.
#pragma once

#include <string_view>
#include <vector>

#include "base/check.hpp"

namespace moat {

/// The force of isolators on the monotone way out, as two lines.
///
///     F                 /        F(d) = Q + k d  for d > d_y
///     |            /  k
///     |      /               Q   strength: mu W of sliders, or that of lead cores
///     Q  /                   k   restoring stiffness: W/R of a pendulum, k_2 of rubber
///     | |                    W   weight on them, static
///     |_|d_y___________ d
///
/// Codes ask for both bounds of the properties: make one backbone of each. Clauses are recalled, not read: compare them
/// with the edition that governs your project.
struct Backbone {
  /// Q >= 0 N.
  Required<Force> strength;
  /// k > 0 N/m.
  Required<Stiffness> restoring_stiffness;
  /// W > 0 N.
  Required<Force> weight;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const;
  /// Q/k: farther out no friction holds the isolators. mu R of a pendulum, with mu of slow motion.
  [[nodiscard]] Length largest_stuck_displacement() const { return strength.value() / restoring_stiffness.value(); }
};

/// A rule of restoring, and its two sides.
struct RestoringCheck {
  std::string_view rule;  ///< code, clause and formula
  double value;           ///< of these isolators, in `unit`
  double limit;           ///< of the code
  std::string_view unit;  ///< SI; "1" without dimension
  bool is_kept;           ///< whether these isolators keep it
};

/// The rules at the design displacement D > 2 d_y, m:
///
///     ASCE 7-16, chapter 17       (F(D) - F(D/2))/W >= 0.025
///     AASHTO, restoring force     (F(D) - F(D/2))/W >= 1/80
///     AASHTO, period              2 pi sqrt(W/(g k)) <= 6 s, of the tangent at D
///     EN 15129                    E_s/E_h >= 0.25, E_s = k D^2/2 stored and E_h = Q D dissipated on the way 0..D
///     EN 1998-2                   D k/Q >= 0.5; where it is not kept, displacement_demand_en_1998_2()
///
/// Throws InputError for a bad backbone or a displacement that is not > 0 m.
std::vector<RestoringCheck> restoring_checks(const Backbone& backbone, Length displacement);

/// rho = 1 + 1.35 (1 - (d_y/d)^0.6)/(1 + 80 (d/d_r)^1.5), the growth of displacements by earlier earthquakes in
/// EN 1998-2. displacement d >= d_y, yield_displacement d_y > 0, stuck_displacement d_r =
/// Backbone::largest_stuck_displacement() > 0, all m.
double accumulation_en_1998_2(Length displacement, Length yield_displacement, Length stuck_displacement);

/// Returns the displacement d_0 + 1.20 d rho that isolators must bear by EN 1998-2 where they do not restore
/// enough. offset: d_0 >= 0 m, of creep, shrinkage and temperature.
Length displacement_demand_en_1998_2(Length offset, Length displacement, Length yield_displacement,
                                     Length stuck_displacement);

}  // namespace moat
