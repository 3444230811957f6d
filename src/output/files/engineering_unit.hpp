// The units engineers read, for tables and charts; files for programs stay in SI.
#pragma once

#include <string>
#include <string_view>

namespace moat {

/// A unit that engineers read.
struct EngineeringUnit {
  std::string symbol;   ///< "cm"
  double per_si = 1.0;  ///< value in this unit = per_si * value in SI
};

/// cm for m, cm/s for m/s, kN for N, kJ for J; any other unit stays as it is.
EngineeringUnit engineering_unit(std::string_view si_symbol);

/// g for m/s^2, in which engineers read accelerations as well; without symbol for any other unit.
EngineeringUnit second_unit(std::string_view si_symbol);

/// A unit for reading: "m/s^2" with a raised 2.
std::string with_raised_digits(std::string_view unit);

/// A quantity's name in words: "absolute_acceleration" -> "absolute acceleration".
std::string in_words(std::string_view quantity);

/// With its first letter in upper case.
std::string capitalised(std::string text);

/// How many decimals show a column whose largest magnitude is `largest` with 4 significant digits: 0 to 6.
int decimals_for(double largest);

/// `value` with so many decimals, 1e12 and above with an exponent; "-" for a value that is not finite.
std::string with_decimals(double value, int decimals);

}  // namespace moat
