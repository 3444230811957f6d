// Quantities as people type them: "10 cm", "0.4g", "2.95e9 N/m^1.5".
#pragma once

#include <string>
#include <string_view>

#include "base/quantity.hpp"

namespace moat {

/// The value in SI units of a number with a unit of the given dimension.
///
/// A unit is made of symbols joined by '/', '*' or a blank, each with an optional power: "kN s/m", "N/m^1.5". All that
/// follows a '/' is divided by. Known symbols: m mm cm km s ms min kg t tonne N kN MN GN J kJ MJ Hz and g, the
/// acceleration of gravity. Throws InputError naming `what` and the text if there is no number, no unit, an unknown
/// symbol, another dimension, a value above 1e15 or too small for a double. A quantity without dimension needs and
/// takes no unit, and may be as large as a double.
double parse_si(std::string_view text, std::string_view what, int mass, int half_length, int time);

/// parse<Length>("10 cm", "--gap")
template <class Q>
Q parse(std::string_view text, std::string_view what) {
  return Q{parse_si(text, what, Q::mass_exponent, Q::half_length_exponent, Q::time_exponent)};
}

}  // namespace moat
