// Round factors of drawings.
#pragma once

#include <cmath>
#include <initializer_list>

namespace moat {

/// The largest of 1, 2, 5, 10, 20, 50 ... that is at most `value`, and at least 1.
inline double round_factor(double value) {
  if (!(value > 1.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= value) return digit * power;
  return power;
}

}  // namespace moat
