#include "reference_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace moat::testing {
namespace {

using Form = ReferenceContact::Form;

// Zero of an increasing function.
template <class Function>
double root_between(double low, double high, Function function) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (function(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// The damping ratio of a spring and dashpot that pull until the gap opens.
double ratio_while_pulling(double e) {
  const double logarithm = std::log(e);
  return -logarithm / std::sqrt(std::numbers::pi * std::numbers::pi + logarithm * logarithm);
}

// Restitution of a spring and dashpot whose contact ends at zero force: m d'' = -k d - c d' solved for the time at
// which k d + c d' = 0 first, below and above critical damping.
double restitution_at_zero_force(double x) {
  if (x == 0.0) return 1.0;
  if (x < 1.0) return std::exp(-2.0 * x / std::sqrt(1.0 - x * x) * std::acos(x));
  if (x == 1.0) return std::exp(-2.0);
  return std::exp(-2.0 * x / std::sqrt(x * x - 1.0) * std::acosh(x));
}

double ratio_at_zero_force(double e) {
  return root_between(0.0, 100.0, [e](double x) { return e - restitution_at_zero_force(x); });
}

// ln((1 + z)/(1 - z e)) = z (1 + e), divided by z^2 and expanded where round-off would eat it.
double exact_hertz_factor(double e) {
  if (e >= 1.0) return 0.0;
  const auto excess = [e](double z) {
    if (z > 0.05) return std::log1p(z) - std::log1p(-z * e) - z * (1.0 + e);
    double sum = 0.0, a = -z * z, b = z * z * e * e;
    for (int n = 2; n < 20; ++n, a *= -z, b *= z * e) sum += (a + b) / n;
    return sum;
  };
  // Negative from z = 0 to the root, positive up to 1/e.
  return root_between(1e-12, (1.0 - 1e-16) / e, excess);
}

double hertz_factor(const PlainLaw& law) {
  const double e = law.restitution;
  switch (law.kind) {
    case PlainLawKind::hertz_damp:
    case PlainLawKind::lankarani_nikravesh:
      return 3.0 * (1.0 - e * e) / 4.0;
    case PlainLawKind::hunt_crossley:
      return 3.0 * (1.0 - e) / 2.0;
    case PlainLawKind::gonthier:
      return (1.0 - e * e) / e;
    case PlainLawKind::ye_2009:
      return 8.0 * (1.0 - e) / (5.0 * e);
    case PlainLawKind::hu_guo:
    case PlainLawKind::modified_hertz_damp:
      return 3.0 * (1.0 - e) / (2.0 * e);
    case PlainLawKind::exact_hertz_damp:
      return exact_hertz_factor(e);
    case PlainLawKind::hertz:
      return 0.0;
    default:
      throw std::logic_error{"reference_contact: a law without equations"};
  }
}

}  // namespace

ReferenceContact reference_contact(const PlainLaw& law, double effective_mass) {
  const double e = law.restitution, k = law.stiffness;
  const double twice_root = 2.0 * std::sqrt(k * effective_mass);
  const bool pulls = law.acts == PlainDamping::may_pull;
  const auto linear = [&](double ratio) {
    return ReferenceContact{Form::linear, k, ratio * twice_root, !pulls, false};
  };
  switch (law.kind) {
    case PlainLawKind::linear_elastic:
      return {Form::linear, k, 0.0, false, false};
    case PlainLawKind::kelvin:
    case PlainLawKind::anagnostopoulos:
      return linear(ratio_while_pulling(e));
    case PlainLawKind::kelvin_by_damping_ratio:
      return linear(law.damping_ratio);
    case PlainLawKind::exact_kelvin:
      return linear(pulls ? ratio_while_pulling(e) : ratio_at_zero_force(e));
    case PlainLawKind::modified_linear_viscoelastic:
      return {Form::linear, k, (1.0 - e * e) / (e * (e * (std::numbers::pi - 2.0) + 2.0)) * twice_root, false, true};
    case PlainLawKind::nonlinear_viscoelastic: {
      const double ratio =
          9.0 * std::sqrt(5.0) / 2.0 * (1.0 - e * e) / (e * (e * (9.0 * std::numbers::pi - 16.0) + 16.0));
      return {Form::root, k, ratio * twice_root, false, true};
    }
    case PlainLawKind::modified_hertz_damp_printed: {
      const double ratio = std::sqrt(5.0) / 10.0 * (1.0 - e * e) / (e * e);
      return {Form::root, k, ratio * twice_root, law.acts == PlainDamping::throughout,
              law.acts == PlainDamping::approach_only};
    }
    default:
      return {Form::hertz, k, hertz_factor(law), !pulls, false};
  }
}

ReferenceContact::Response ReferenceContact::evaluate(double indentation, double rate, double approach_speed,
                                                      bool approaching) const {
  const double d = indentation;
  const double c = approach_only && !approaching ? 0.0 : damping;
  if (form == Form::linear) return {stiffness * d + c * rate, stiffness, c};
  if (d <= 0.0) return {0.0, 0.0, 0.0};
  const double elastic = stiffness * d * std::sqrt(d), slope = 1.5 * stiffness * std::sqrt(d);
  if (form == Form::root) {
    const double fourth = std::sqrt(std::sqrt(d));
    return {elastic + c * fourth * rate, slope + 0.25 * c * fourth / d * rate, c * fourth};
  }
  const double ratio = std::clamp(rate / approach_speed, -100.0, 100.0);
  const double factor = 1.0 + c * ratio;
  return {elastic * factor, slope * factor, std::abs(ratio) < 100.0 ? elastic * c / approach_speed : 0.0};
}

ReferenceContact::Rated ReferenceContact::push(double indentation, double rate, double acceleration,
                                               double approach_speed) const {
  if (form == Form::linear)
    return {indentation + damping / stiffness * rate, rate + damping / stiffness * acceleration};
  if (form == Form::root) {
    const double d = std::max(indentation, 0.0), fourth = std::sqrt(std::sqrt(d));
    return {d * fourth + damping / stiffness * rate, 1.25 * fourth * rate + damping / stiffness * acceleration};
  }
  const double ratio = rate / approach_speed;
  if (std::abs(ratio) >= 100.0) return {1.0 + damping * std::copysign(100.0, ratio), 0.0};
  return {1.0 + damping * ratio, damping * acceleration / approach_speed};
}

double ReferenceContact::duration(double effective_mass, double approach_speed) const {
  if (form == Form::linear) return std::numbers::pi * std::sqrt(effective_mass / stiffness);
  const double deepest = std::pow(1.25 * effective_mass * approach_speed * approach_speed / stiffness, 0.4);
  return 2.94 * deepest / approach_speed;
}

}  // namespace moat::testing
