// Zeros of functions of one variable.
#pragma once

#include <functional>

namespace moat {

/// An interval at whose ends a function has different signs.
struct Bracket {
  double low, high;  ///< the root is between them
};

/// Narrows an interval around a zero of a continuous function until it is `width` long or has only its last digits
/// left: the method of Alefeld, Potra and Shi (TOMS algorithm 748). Throws std::logic_error if the function has the
/// same sign, other than zero, at both ends.
Bracket bracket_root(const std::function<double(double)>& function, double low, double high, double width = 0.0);

/// A zero of a continuous function between two points where its signs differ, to the last digits. Throws as
/// bracket_root().
double root_between(const std::function<double(double)>& function, double low, double high);

}  // namespace moat
