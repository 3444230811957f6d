// Hysteresis of two components that saturates on a circle.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/plan_vector.hpp"
#include "materials/planar_response.hpp"

namespace moat {

/// The history of a saturating law: z = its hysteretic force over the strength, |z| <= 1, at a deformation.
struct SaturatingState {
  PlanVector z{};
  PlanVector deformation{};  ///< m
  double dissipated = 0.0;   ///< over strength times yield displacement, since the start

  friend bool operator==(const SaturatingState&, const SaturatingState&) = default;
};

/// How z follows a straight increment D of the deformation of length s = |D|/d_y. With t = D/|D|, m = t turned left
/// and z = p t + q m, the pull towards the direction of motion has the closed form
///
///     p1 = (p + tanh s)/(1 + p tanh s)     q1 = q sech s/(1 + p tanh s)     (p >= 0)
///
/// which solves z' = t - z (z.t) for |z| <= 1, and on |z| = 1 is Krieg & Krieg's tan(psi1/2) = tan(psi0/2) exp(-s).
/// It dissipates [ln(cosh s + p sinh s) - (|z1|^2 - |z0|^2)/2] of strength times d_y. Before that z grows elastically,
/// z' = t: while p < 0 (`from_the_start`), or inside the circle (`on_the_circle`).
class SaturatingSlip {
 public:
  enum class Begins { from_the_start, on_the_circle };

  /// `reach`: d_y > 0, m.
  SaturatingSlip(Begins begins, double reach) : begins_{begins}, reach_{reach} {}

  struct Step {
    PlanVector z;
    PlanMatrix derivative;  ///< of z by the increment of deformation, 1/m
    PlanVector rate;        ///< of z at the end, while the deformation goes on at its rate, 1/s
    double dissipated;      ///< over strength times d_y
    PlanMatrix by_start;    ///< derivative of z by that at the start
  };

  /// From z0 by an increment, m, that ends at this rate, m/s.
  [[nodiscard]] Step advance(PlanVector z0, PlanVector increment, PlanVector rate) const {
    const double size = std::sqrt(dot(increment, increment));
    constexpr double negligible = 1e-12;  // of d_y
    if (size <= negligible * reach_) {
      // No direction of its own: that of the rate, along which the next increment will go.
      const PlanMatrix derivative = slope(z0, rate);
      return {z0 + derivative * increment, derivative, derivative * rate, 0.0, PlanMatrix::diagonal(1.0)};
    }
    const PlanVector t = increment / size, m = turned_left(t);
    const double s = size / reach_, p = dot(z0, t), q = dot(z0, m);
    const Parts parts = begins_ == Begins::from_the_start ? pulled_from_the_start(p, q, s) : pulled_on_circle(p, q, s);
    const PlanVector z1 = parts.p * t + parts.q * m;
    // Along t; across it the increment turns by dphi, so that dp = q dphi, dq = -p dphi, dt = m dphi, dm = -t dphi.
    const PlanVector along = parts.pulls ? t - std::max(dot(z1, t), 0.0) * z1 : t;
    const PlanVector across =
        (parts.p_by_p * q - parts.p_by_q * p - parts.q) * t + (parts.q_by_p * q - parts.q_by_q * p + parts.p) * m;
    const PlanMatrix derivative = PlanMatrix::product(along / reach_, t) + PlanMatrix::product(across / size, m);
    const PlanMatrix by_start = PlanMatrix::product(parts.p_by_p * t + parts.q_by_p * m, t) +
                                PlanMatrix::product(parts.p_by_q * t + parts.q_by_q * m, m);
    return {z1, derivative, slope(z1, rate) * rate, parts.dissipated, by_start};
  }

 private:
  struct Parts {
    double p, q;
    double p_by_p, p_by_q, q_by_p, q_by_q;
    bool pulls;
    double dissipated;
  };

  // dz/d(deformation) along a direction of motion, 1/m.
  [[nodiscard]] PlanMatrix slope(PlanVector z, PlanVector direction) const {
    constexpr double round_off = 1e-9;
    const bool saturates = begins_ == Begins::from_the_start || dot(z, z) >= 1.0 - round_off;
    const PlanMatrix elastic = PlanMatrix::diagonal(1.0);
    const bool pulls = saturates && dot(z, direction) > 0.0;
    return (1.0 / reach_) * (pulls ? elastic + -1.0 * PlanMatrix::product(z, z) : elastic);
  }

  // The closed form from p >= 0 on, with ln(cosh s + p sinh s) in a form that does not overflow.
  static Parts pulled(double p, double q, double s) {
    const double tanh_s = std::tanh(s), sech_s = 1.0 / std::cosh(std::min(s, 700.0)), w = 1.0 + p * tanh_s;
    const double ratio = sech_s / w, p1 = (p + tanh_s) / w, q1 = q * ratio;
    const double fading = std::exp(-2.0 * s);
    const double work = s + std::log(0.5 * (1.0 + p) + 0.5 * (1.0 - p) * fading);
    return {p1,
            q1,
            ratio * ratio,
            0.0,
            -q * ratio * tanh_s / w,
            ratio,
            true,
            work - 0.5 * (p1 * p1 + q1 * q1 - p * p - q * q)};
  }

  static Parts pulled_from_the_start(double p, double q, double s) {
    if (p >= 0.0) return pulled(p, q, s);
    if (s <= -p) return {p + s, q, 1.0, 0.0, 0.0, 1.0, false, 0.0};
    Parts parts = pulled(0.0, q, s + p);
    // p shortens the pull: d/dp is d/ds.
    parts.p_by_p = 1.0 - parts.p * parts.p;
    parts.q_by_p = -parts.q * parts.p;
    return parts;
  }

  static Parts pulled_on_circle(double p, double q, double s) {
    const double c = std::sqrt(std::max(1.0 - q * q, 0.0));
    const double until_circle = std::max(c - p, 0.0);
    if (s <= until_circle) return {p + s, q, 1.0, 0.0, 0.0, 1.0, false, 0.0};
    Parts parts = pulled(c, q, s - until_circle);
    // z1 = (tanh x, +-sech x) with x = atanh(c) + s + p - c: dx/dp = 1, dx/dq = -c/q.
    const double ratio = parts.q_by_q;
    parts.p_by_p = parts.q * parts.q;
    parts.p_by_q = -c * parts.q * ratio;
    parts.q_by_p = -parts.q * parts.p;
    parts.q_by_q = c * parts.p * ratio;
    return parts;
  }

  Begins begins_;
  double reach_;
};

/// The response F = k2 d + Q z of a law with this history: `strength` Q, N, and `post_yield_stiffness` k2, N/m.
inline PlanarResponse saturating_response(const SaturatingSlip& slip, double strength, double post_yield_stiffness,
                                          const SaturatingState& committed, PlanVector deformation, PlanVector rate,
                                          SaturatingState& trial) {
  const SaturatingSlip::Step step = slip.advance(committed.z, deformation - committed.deformation, rate);
  trial = {step.z, deformation, committed.dissipated + step.dissipated};
  return {.force = post_yield_stiffness * deformation + strength * step.z,
          .stiffness = PlanMatrix::diagonal(post_yield_stiffness) + strength * step.derivative,
          .damping = {},
          .force_rate = post_yield_stiffness * rate + strength * step.rate};
}

}  // namespace moat
