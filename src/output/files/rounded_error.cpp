#include "output/files/rounded_error.hpp"

#include <cmath>
#include <limits>

#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"

namespace moat {

RoundedError rounded_error(double error) {
  constexpr int any_number = std::numeric_limits<int>::max();
  constexpr int most_decimals_as_number = 6;
  if (!std::isfinite(error)) return {"", any_number};
  if (error <= 0.0) return {"0", any_number};
  constexpr double round_off = 1e-9;  // 0.02 stays 0.02
  int exponent = static_cast<int>(std::floor(std::log10(error)));
  double digits = error * std::pow(10.0, -exponent);  // from 1 to 10
  int decimals = -exponent;
  if (digits < 2.0 - 0.1 + round_off) {
    ++decimals;
    digits = std::ceil(10.0 * digits - round_off);
  } else {
    digits = std::ceil(digits - round_off);  // 10 is 1 with another digit
  }
  const double rounded = digits * std::pow(10.0, -decimals);
  if (decimals <= most_decimals_as_number) return {with_decimals(rounded, decimals < 0 ? 0 : decimals), decimals};
  return {to_significant(rounded, 2), decimals};
}

double rounded_to(double value, int decimals) {
  if (decimals >= 0) return value;  // printing rounds
  const double unit = std::pow(10.0, -decimals);
  return unit * std::round(value / unit);
}

}  // namespace moat
