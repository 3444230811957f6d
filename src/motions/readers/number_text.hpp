// Decimal numbers as Fortran, C and spreadsheets write them.
#pragma once

#include <cstddef>
#include <string_view>

namespace moat {

/// A number at the beginning of a text.
struct ScannedNumber {
  double value = 0.0;
  std::size_t length = 0;         ///< characters read
  bool has_exponent = false;      ///< it ended with an exponent
  const char* problem = nullptr;  ///< why there is no number; null if there is one
};

/// Reads one decimal number from the beginning of `text`: optional sign, digits with an optional point, optional
/// exponent of up to three digits after E or D ("-.1234E-03", "0.1D-02", "12", "+5."). Never skips blanks. "nan",
/// "inf" and numbers too large or too small for a double are problems.
ScannedNumber scan_number(std::string_view text);

/// Like scan_number, but the number must be all of `text`.
ScannedNumber parse_number(std::string_view text);

}  // namespace moat
