// Errors as they are printed, and the digits that they leave to a value.
#pragma once

#include <string>

namespace moat {

/// An error rounded up to one significant digit, to two if the first is 1: 0.0204 -> "0.03", 0.0113 -> "0.012".
struct RoundedError {
  std::string text;  ///< empty for an error that is not known
  /// Decimal place of its last digit; negative where that is 10, 100 ... A value has no more digits than this. Very
  /// many for an error of zero or one that is not known.
  int decimals = 0;
};

/// `error` >= 0, in any unit; not finite if it is not known.
RoundedError rounded_error(double error);

/// `value` rounded to so many decimals: 2563 to -1 is 2560.
double rounded_to(double value, int decimals);

}  // namespace moat
