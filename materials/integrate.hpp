// Ordinary differential equations inside a law.
#pragma once

#include <array>
#include <functional>

namespace moat {

/// y(end) of y' = rate(y) from y(0) = start, end >= 0, two unknowns: Dormand and Prince's method of order five (1980)
/// in steps of at most `longest`, with an error of each step below `tolerance` (1 + |y| + step |y'|). Pure. Throws
/// std::runtime_error where no step is short enough.
std::array<double, 2> integrate(const std::function<std::array<double, 2>(const std::array<double, 2>&)>& rate,
                                std::array<double, 2> start, double end, double longest, double tolerance);

}  // namespace moat
