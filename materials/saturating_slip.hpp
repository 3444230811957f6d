// Hysteresis of two components that saturates on a circle.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/plan_vector.hpp"
#include "materials/plan/planar_response.hpp"

namespace moat {

/// The history of a saturating law: z = its hysteretic force over the strength, |z| <= 1, at a deformation.
struct SaturatingState {
  PlanVector z{};            ///< of length <= 1
  PlanVector deformation{};  ///< m
  PlanVector rate{};         ///< m/s, of the deformation
  double dissipated = 0.0;   ///< over strength times yield displacement, since the start

  friend bool operator==(const SaturatingState&, const SaturatingState&) = default;
};

/// How z follows a step of the deformation. While it is pulled, z' = w - z (z.w) with w = d'/d_y: the motion in a disk
/// of z = Z/W with
///
///     Z' = w W,   W' = w.Z,   a linear equation whose matrix [0 w; w^T 0] generates hyperbolic rotations.
///
/// Over a path with the chord D d_y and the signed area a d_y^2 between path and chord, positive where the path turns
/// left, the first two terms of its Magnus series are
///
///     [Z1 W1] = exp([a J, D; D^T, 0]) [z0 1],   J a turn to the left by 90 degrees,
///
/// whose exponential is closed. The next terms are of fifth order in the step. For a straight path a = 0: it is then
/// exact, z1 = (p + tanh s, q sech s)/(1 + p tanh s) along and across D of length s, and on |z| = 1 Krieg & Krieg's
/// tan(psi1/2) = tan(psi0/2) exp(-s). It keeps |z| <= 1 for every a, and dissipates ln(W1/W0) - (|z1|^2 - |z0|^2)/2 of
/// strength times d_y, because z.w = W'/W. Before that z grows elastically, z' = w: while z.w < 0 (`from_the_start`),
/// or inside the circle (`on_the_circle`). Where a step begins elastically its chord decides when it ends to be so, and
/// the rest has the share of the area that a path of constant curvature gives it, that of its length cubed.
///
/// The path is the cubic through deformations and rates at both ends of the step. Beyond s^2/(4 + 2 s), which a path of
/// constant curvature reaches where it turns by about 130 degrees, its area is cut off: this is a path that turns back,
/// and no longer one that the series describes.
///
/// Magnus 1954, On the exponential solution of differential equations for a linear operator; Iserles & Norsett 1999.
class SaturatingSlip {
 public:
  /// Where the step begins: at the z of its start, or on the circle |z| = 1.
  enum class Begins { from_the_start, on_the_circle };

  /// `reach`: d_y > 0, m. Where a circle grows or shrinks in the step, it belongs to the mean circle, and
  /// `elastic_reach` > 0 m that of the circle at the end, over which z grows elastically.
  SaturatingSlip(Begins begins, double reach, double elastic_reach)
      : begins_{begins}, reach_{reach}, stretch_{elastic_reach / reach} {}
  /// Has the same reach on both sides.
  SaturatingSlip(Begins begins, double reach) : SaturatingSlip{begins, reach, reach} {}

  /// The end of a step, and its derivatives.
  struct Step {
    PlanVector z;             ///< at the end
    PlanMatrix by_increment;  ///< derivative of z, 1/m
    PlanMatrix by_rate;       ///< derivative by the rate at the end, s/m
    PlanMatrix by_start;      ///< derivative by z at the start
    PlanVector by_scale;      ///< derivative by a factor of the increment and of both rates
    PlanVector by_stretch;    ///< derivative by elastic_reach/reach
    PlanVector rate;          ///< of z at the end, while the deformation goes on at its rate, 1/s
    double dissipated;        ///< over strength times d_y
  };

  /// From z0 by an increment, m, in `interval` s with these rates at both ends, m/s.
  [[nodiscard]] Step advance(PlanVector z0, PlanVector increment, PlanVector rate_before, PlanVector rate,
                             double interval) const {
    const double size = std::sqrt(dot(increment, increment));
    constexpr double negligible = 1e-12;  // of d_y
    if (size <= negligible * reach_) {
      // No direction of its own: that of the rate, along which the next increment will go.
      const PlanMatrix derivative = slope(z0, rate);
      return {z0 + derivative * increment, derivative, {}, PlanMatrix::diagonal(1.0), derivative * increment, {},
              derivative * rate,           0.0};
    }
    const PlanVector t = increment / size, m = turned_left(t);
    const double s = size / reach_;
    // The area of the cubic is h/10 (v0 - v1) x D - h^2/60 v0 x v1.
    const PlanVector bend = 0.1 * interval * (rate_before - rate);
    const double twist = interval * interval / 60.0, per_square = 1.0 / (reach_ * reach_);
    const double area = per_square * (cross(bend, increment) - twist * cross(rate_before, rate));
    const PlanVector area_by_increment = per_square * turned_left(bend),
                     area_by_rate =
                         per_square * (0.1 * interval * turned_left(increment) - twist * turned_left(rate_before));
    const double p = dot(z0, t), q = dot(z0, m);
    const Parts end = pulled_after_elastic(p, q, s, area);
    const auto vector = [&](Pair parts) { return parts.p * t + parts.q * m; };
    const PlanVector z1 = vector(end.at), by_size = vector(end.by_size), by_area = vector(end.by_area),
                     by_p = vector(end.by_p), by_q = vector(end.by_q);
    // Where the increment turns by dphi, p and q of z0 change by q dphi and -p dphi, and dt = m dphi, dm = -t dphi.
    const PlanVector by_turn = q * by_p - p * by_q + turned_left(z1);
    return {z1,
            PlanMatrix::product(by_size / reach_, t) + PlanMatrix::product(by_turn / size, m) +
                PlanMatrix::product(by_area, area_by_increment),
            PlanMatrix::product(by_area, area_by_rate),
            PlanMatrix::product(by_p, t) + PlanMatrix::product(by_q, m),
            s * by_size + 2.0 * area * by_area,
            vector(end.by_stretch),
            slope(z1, rate) * rate,
            end.dissipated};
  }

 private:
  // Components of z along and across the increment.
  struct Pair {
    double p, q;

    friend Pair operator+(Pair a, Pair b) { return {a.p + b.p, a.q + b.q}; }
    friend Pair operator*(double factor, Pair a) { return {factor * a.p, factor * a.q}; }
  };
  // z at the end and its derivatives, by_p and by_q those by z at the start.
  struct Parts {
    Pair at, by_p, by_q, by_size, by_area;
    double dissipated;
    Pair by_stretch{};
  };

  // dz/d(deformation) along a direction of motion, 1/m.
  [[nodiscard]] PlanMatrix slope(PlanVector z, PlanVector direction) const {
    constexpr double round_off = 1e-9;
    const bool saturates = begins_ == Begins::from_the_start || dot(z, z) >= 1.0 - round_off;
    const PlanMatrix elastic = PlanMatrix::diagonal(1.0);
    const bool pulls = saturates && dot(z, direction) > 0.0;
    return 1.0 / (reach_ * stretch_) * (pulls ? elastic + -1.0 * PlanMatrix::product(z, z) : elastic);
  }

  // sinh(x)/x = S and (cosh x - 1)/x^2 = C of y = x^2 >= 0 with their derivatives by y, cosh x and 1, all times
  // exp(-x).
  struct Hyperbolic {
    double one, cosh, s, c, s_by_y, c_by_y, log_of_scale;
  };
  static Hyperbolic hyperbolic(double y) {
    constexpr double short_series = 0.04;
    if (y < short_series) {
      const double s = 1.0 + y / 6.0 * (1.0 + y / 20.0 * (1.0 + y / 42.0 * (1.0 + y / 72.0 * (1.0 + y / 110.0)))),
                   c = 0.5 *
                       (1.0 + y / 12.0 * (1.0 + y / 30.0 * (1.0 + y / 56.0 * (1.0 + y / 90.0 * (1.0 + y / 132.0))))),
                   s_by_y = 1.0 / 6.0 * (1.0 + y / 10.0 * (1.0 + y / 28.0 * (1.0 + y / 54.0 * (1.0 + y / 88.0)))),
                   c_by_y = 1.0 / 24.0 *
                            (1.0 + y / 15.0 * (1.0 + y / 37.333333333333336 * (1.0 + y / 67.5 * (1.0 + y / 105.6))));
      return {1.0, 1.0 + c * y, s, c, s_by_y, c_by_y, 0.0};
    }
    const double x = std::sqrt(y), one = std::exp(-x), cosh = 0.5 * (1.0 + one * one), s = 0.5 * (1.0 - one * one) / x,
                 c = (cosh - one) / y;
    return {one, cosh, s, c, 0.5 * (cosh - s) / y, (0.5 * s - c) / y, x};
  }

  // The exponential above, of z = (p, q) over a chord of length s with the area a, |a| < s.
  static Parts pulled(double p, double q, double s, double a) {
    const Hyperbolic h = hyperbolic((s - a) * (s + a));
    const double u = s - a * q, scaled_area = h.s * p + h.c * u, scaled_area_by_y = h.s_by_y * p + h.c_by_y * u;
    // Z1 and W1, and Z0 = z0, W0 = 1.
    const double along = p * h.cosh + h.s * u, across = q * h.one + a * scaled_area, w = h.one + s * scaled_area;
    const double p1 = along / w, q1 = across / w;
    // d(x/w) = (dx - x/w dw)/w.
    const auto of = [&](double d_along, double d_across, double d_w) {
      return Pair{(d_along - p1 * d_w) / w, (d_across - q1 * d_w) / w};
    };
    const double y_by_s = 2.0 * s, y_by_a = -2.0 * a;
    const auto by_y = [&](double factor) {
      return Pair{factor * (0.5 * h.s * p + h.s_by_y * u), factor * scaled_area_by_y};
    };
    const Pair of_s = by_y(y_by_s), of_a = by_y(y_by_a);
    return {{p1, q1},
            of(h.cosh, a * h.s, s * h.s),
            of(-a * h.s, h.one - a * a * h.c, -s * a * h.c),
            of(of_s.p + h.s, a * (of_s.q + h.c), scaled_area + s * (of_s.q + h.c)),
            of(of_a.p - h.s * q, scaled_area + a * (of_a.q - h.c * q), s * (of_a.q - h.c * q)),
            h.log_of_scale + std::log(w) - 0.5 * (p1 * p1 + q1 * q1 - p * p - q * q)};
  }

  [[nodiscard]] Parts pulled_after_elastic(double p, double q, double s, double area) const {
    // The length at which the pull begins, p there, and their derivatives by p and q.
    double elastic = 0.0, begin = p, elastic_by_p = 0.0, elastic_by_q = 0.0, begin_by_p = 1.0, begin_by_q = 0.0;
    if (begins_ == Begins::on_the_circle) {
      const double c = std::sqrt(std::max(1.0 - q * q, 0.0)), c_by_q = c > 0.0 ? -q / c : 0.0;
      const bool inside = p < c;
      elastic = inside ? c - p : 0.0;
      elastic_by_p = inside ? -1.0 : 0.0;
      elastic_by_q = inside ? c_by_q : 0.0;
      begin = c;
      begin_by_p = 0.0;
      begin_by_q = c_by_q;
    } else if (p < 0.0) {
      elastic = -p;
      elastic_by_p = -1.0;
      begin = begin_by_p = 0.0;
    }
    const double by_stretch = elastic;
    elastic *= stretch_;
    elastic_by_p *= stretch_;
    elastic_by_q *= stretch_;
    if (s <= elastic)
      return {{p + s / stretch_, q},
              {1.0, 0.0},
              {0.0, 1.0},
              {1.0 / stretch_, 0.0},
              {0.0, 0.0},
              0.0,
              {-s / (stretch_ * stretch_), 0.0}};

    // The area, cut off at s^2/(4 + 2 s), and its part in the rest of the path.
    const double most = 0.5 * s * s / (2.0 + s);
    const bool cut = std::abs(area) > most;
    const double all = cut ? std::copysign(most, area) : area;
    const double all_by_size = cut ? all * (4.0 + s) / (s * (2.0 + s)) : 0.0;
    const double rest = s - elastic, share = rest / s, part = share * share * share;
    const double part_by_rest = 3.0 * share * share / s;
    const Parts end = pulled(begin, q, rest, all * part);
    // The derivative by the rest's length, with its part of the area, the whole length unchanged.
    const Pair by_rest = end.by_size + (all * part_by_rest) * end.by_area;
    return {end.at,
            begin_by_p * end.by_p + -elastic_by_p * by_rest,
            begin_by_q * end.by_p + end.by_q + -elastic_by_q * by_rest,
            by_rest + (all_by_size * part - all * part_by_rest * share) * end.by_area,
            (cut ? 0.0 : part) * end.by_area,
            end.dissipated,
            -by_stretch * by_rest};
  }

  Begins begins_;
  double reach_, stretch_;
};

/// The response F = k2 d + Q z of a law with this history: `strength` Q, N, and `post_yield_stiffness` k2, N/m.
inline PlanarResponse saturating_response(const SaturatingSlip& slip, double strength, double post_yield_stiffness,
                                          const SaturatingState& committed, PlanVector deformation, PlanVector rate,
                                          double interval, SaturatingState& trial) {
  const SaturatingSlip::Step step =
      slip.advance(committed.z, deformation - committed.deformation, committed.rate, rate, interval);
  trial = {step.z, deformation, rate, committed.dissipated + step.dissipated};
  return {.force = post_yield_stiffness * deformation + strength * step.z,
          .stiffness = PlanMatrix::diagonal(post_yield_stiffness) + strength * step.by_increment,
          .damping = strength * step.by_rate,
          .force_rate = post_yield_stiffness * rate + strength * step.rate};
}

}  // namespace moat
