// Linear springs in place of Hertz springs, and both in series.
#pragma once

#include "base/required.hpp"
#include "base/units.hpp"

namespace moat {

/// Two bodies that approach each other in free flight.
struct Approach {
  Required<Mass> mass;    ///< m > 0 kg, effective: 1/m = 1/m_1 + 1/m_2.
  Required<Speed> speed;  ///< v > 0 m/s, at touch.
};

/// The quantity of an elastic free impact in which a linear and a Hertz spring agree.
enum class Equal {
  force,        ///< the largest force
  duration,     ///< of the contact
  indentation,  ///< the largest indentation, and with it the energy there
};

/// Returns the linear spring that agrees with a Hertz spring k_h > 0 N/m^1.5 in one elastic impact, N/m:
///
///     k = C k_h^0.8 (m v^2)^0.2    C = (5/4)^1.2 for equal force, pi^2/(2.94328^2 (5/4)^0.8) for equal duration,
///                                  (4/5)^0.8 for equal indentation
///
/// It holds for this speed alone: k grows as v^0.4. Throws InputError for a parameter outside its range.
Stiffness linear_stiffness(HertzStiffness stiffness, const Approach& approach, Equal equal = Equal::force);
/// Returns the Hertz spring of a linear one k > 0 N/m, N/m^1.5: the inverse. Throws InputError as it does.
HertzStiffness hertz_stiffness(Stiffness stiffness, const Approach& approach, Equal equal = Equal::force);

/// Returns the Hertz spring that has the largest force of a Hertz spring k_h and a linear spring k in series, N/m^1.5:
///
///     k_eq = F^2.5/((5/4) m v^2)^1.5,  where  (2/5) F^(5/3)/k_h^(2/3) + F^2/(2 k) = m v^2/2
///
/// Throws InputError for a parameter outside its range.
HertzStiffness in_series(HertzStiffness local, Stiffness behind, const Approach& approach);

/// Returns the duration of a free elastic impact on a Hertz spring, s: 2.94328 d/v with the indentation
/// d = (5 m v^2/(4 k_h))^(2/5). Throws InputError for a parameter outside its range.
Time duration_of_free_impact(HertzStiffness stiffness, const Approach& approach);

}  // namespace moat
