#include "materials/contact/restitution_formulas.hpp"

#include <cmath>
#include <numbers>

#include "base/root.hpp"

namespace moat {
namespace {

// a cot a with cos a = x.
double angle_times_cotangent(double x) {
  if (x <= 1.0) {
    const double angle = std::acos(x);
    return angle == 0.0 ? 1.0 : x * angle / std::sin(angle);
  }
  const double angle = std::acosh(x);
  return x * angle / std::sinh(angle);
}

// y - ln(1 + y), which loses all digits for small y if it is written so.
double excess_over_logarithm(double y) {
  if (std::abs(y) > 0.1) return y - std::log1p(y);
  double sum = 0.0, power = y * y;
  for (int n = 2; n < 24; ++n, power *= -y) sum += power / n;
  return sum;
}

// z of the equation divided by z^2, a power series. For e near 1, where the equation itself loses all digits.
double small_damping_factor(double e) {
  const auto divided = [e](double z) {
    double sum = 0.0, z_power = 1.0, e_power = e * e, sign = -1.0;
    for (int n = 2; n < 40; ++n) {
      sum += z_power * (sign + e_power) / n;
      z_power *= z;
      e_power *= e;
      sign = -sign;
    }
    return sum;
  };
  const double near = 0.75 * (1.0 - e) * (1.0 + e);
  return root_between(divided, 0.5 * near, 2.0 * near);
}

}  // namespace

double restitution_of_pulling_contact(double damping_ratio) {
  if (damping_ratio >= 1.0) return 0.0;
  return std::exp(-std::numbers::pi * damping_ratio / std::sqrt((1.0 - damping_ratio) * (1.0 + damping_ratio)));
}

double restitution_of_clamped_contact(double damping_ratio) {
  return std::exp(-2.0 * angle_times_cotangent(damping_ratio));
}

double restitution_of_approach_damping(double damping_ratio) { return std::exp(-angle_times_cotangent(damping_ratio)); }

double damping_ratio_of_pulling_contact(double restitution) {
  const double logarithm = -std::log(restitution);
  return logarithm / std::hypot(std::numbers::pi, logarithm);
}

double damping_ratio_of_clamped_contact(double restitution) {
  if (restitution == 1.0) return 0.0;
  const double wanted = -0.5 * std::log(restitution);
  // For large x, e = 1/(4 x^2).
  return root_between([wanted](double x) { return angle_times_cotangent(x) - wanted; }, 0.0,
                      1.0 / std::sqrt(restitution));
}

double restitution_of_viscous_hertz(double damping_factor) {
  if (damping_factor == 0.0) return 1.0;
  // With 1 - z e = exp(-p): p - (1 - exp(-p)) = z - ln(1 + z).
  const double wanted = excess_over_logarithm(damping_factor);
  const auto missing = [wanted](double p) {
    const double left = p < 0.1 ? excess_over_logarithm(std::expm1(-p)) : p + std::expm1(-p);
    return left - wanted;
  };
  const double p = root_between(missing, 0.0, wanted + 2.0);
  return -std::expm1(-p) / damping_factor;
}

double damping_factor_of_viscous_hertz(double restitution) {
  const double e = restitution;
  if (e == 1.0) return 0.0;
  if (e > 0.9) return small_damping_factor(e);
  // In terms of u = ln(1 - z e), because z comes so close to 1/e that 1 - z e has no digits left.
  const auto missing = [e](double u) {
    const double z = -std::expm1(u) / e;
    return std::log1p(z) - u - z * (1.0 + e);
  };
  const double deepest = std::log1p(1.0 / e) - (1.0 + e) / e - 1.0;
  // 3/4 (1 - e^2) delivers more than e.
  const double too_elastic = std::log1p(-0.75 * e * (1.0 - e) * (1.0 + e));
  return -std::expm1(root_between(missing, deepest, too_elastic)) / e;
}

double elastic_hertz_duration(double stiffness, double effective_mass, double approach_speed) {
  const double deepest = std::pow(1.25 * effective_mass * approach_speed * approach_speed / stiffness, 0.4);
  // 2 B(2/5, 1/2)/5 times deepest / v0, with Euler's beta function.
  return 2.94327518 * deepest / approach_speed;
}

}  // namespace moat
