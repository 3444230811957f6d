#include "materials/integrate.hpp"

#include <algorithm>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>  // the tolerances count
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>

namespace moat {

namespace odeint = boost::numeric::odeint;

std::array<double, 2> integrate(const std::function<std::array<double, 2>(const std::array<double, 2>&)>& rate,
                                std::array<double, 2> start, double end, double longest, double tolerance) {
  using Values = std::array<double, 2>;
  if (end == 0.0) return start;
  const auto slope = [&rate](const Values& y, Values& by_path, double) { by_path = rate(y); };
  odeint::integrate_adaptive(
      odeint::make_controlled(tolerance, tolerance, longest, odeint::runge_kutta_dopri5<Values>{}), slope, start, 0.0,
      end, std::min(longest, end));
  return start;
}

}  // namespace moat
