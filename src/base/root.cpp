#include "base/root.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace moat {

Bracket bracket_root(const std::function<double(double)>& function, double low, double high, double width) {
  const double at_low = function(low), at_high = function(high);
  if (at_low == 0.0) return {low, low};
  if (at_high == 0.0) return {high, high};
  if (std::signbit(at_low) == std::signbit(at_high))
    throw std::logic_error{"bracket_root: the function has the same sign at both ends"};
  boost::math::tools::eps_tolerance<double> last_digits{std::numeric_limits<double>::digits};
  const auto close = [&](double a, double b) { return b - a <= width || last_digits(a, b); };
  // The method halves the interval in at most three evaluations, over all exponents of a double.
  std::uintmax_t most_evaluations = std::uintmax_t{3} * 2100;
  const auto [a, b] = boost::math::tools::toms748_solve(function, low, high, at_low, at_high, close, most_evaluations);
  return {a, b};
}

double root_between(const std::function<double(double)>& function, double low, double high) {
  const Bracket bracket = bracket_root(function, low, high);
  return bracket.low + 0.5 * (bracket.high - bracket.low);
}

}  // namespace moat
