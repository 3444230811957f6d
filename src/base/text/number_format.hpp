// Numbers as text, the same in every locale of the calling program.
#pragma once

#include <string>

namespace moat {

/// With so many digits after the decimal point, >= 0; "nan" and "inf" for values that are not finite.
std::string to_fixed(double value, int decimals);

/// With at most so many significant digits, >= 1, and an exponent where that is shorter: "0.0125", "1.2e-09".
std::string to_significant(double value, int digits);

/// With as few digits as give the same number when they are read again: "0.01", "0.016666666666666666".
std::string to_exact(double value);

}  // namespace moat
