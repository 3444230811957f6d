// Rubber compounds of high damping.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moat {

/// Measured properties of a rubber compound over the shear strain g, and the parameters of its loops.
///
///     G_eq = f(g)    N/m^2, stiffness of the loop of amplitude g        h_eq = f(g)    its damping ratio
///     u = f(g)       hysteretic share of the force                      n = f(g)       exponent of the elastic part
///
/// The fits hold up to g = 4.1; beyond, the skeleton G_eq g goes on along its tangent and the rest stays. Source:
/// KikuchiAikenHDR of OpenSees, after Kikuchi & Aiken (1997).
struct RubberCompound {
  /// The compounds that were fitted.
  enum class Kind : int {
    x06,  ///< Bridgestone X0.6
    x04,  ///< Bridgestone X0.4
  };
  static constexpr double largest_strain = 4.1;  ///< Limit of the fit; beyond it the skeleton goes on straight.

  Kind kind = Kind::x06;  ///< the compound

  /// At a strain > 0: G_eq N/m^2, h_eq, u, n.
  [[nodiscard]] double shear_modulus(double g) const {
    if (g > largest_strain) return skeleton(g) / g;
    const double mega =
        kind == Kind::x06
            ? (g < 1.15 ? 0.68358 * std::pow(g, -0.39964) : 1.10103 + g * (-0.61946 + g * (0.22047 - 0.022191 * g)))
            : (g < 2.0 ? 0.38073 * std::pow(g, -0.42052) : 0.46499 + g * (-0.12723 + 0.0184823 * g));
    return 1e6 * mega;
  }
  /// H_eq, 1.
  [[nodiscard]] double damping_ratio(double g) const {
    g = std::min(g, largest_strain);
    return kind == Kind::x06 ? 0.23834 + g * (-0.028108 + 8.7664e-5 * g)
                             : 0.22184 + g * (0.0059574 + g * (-0.0072693 + 0.0014267 * g));
  }
  /// U, 1: the share of the hysteretic force.
  [[nodiscard]] double hysteretic_share(double g) const {
    g = std::min(g, largest_strain);
    return kind == Kind::x06 ? 0.44236 + g * (-0.062943 - 0.0037571 * g)
                             : 0.42715 + g * (-0.041644 + g * (0.0070867 - 0.0019158 * g));
  }
  /// N, 1: of the elastic force.
  [[nodiscard]] double elastic_exponent(double g) const {
    g = std::min(g, largest_strain);
    if (kind == Kind::x06) return g < 1.5 ? 1.0 : 0.91173 + g * (-0.59184 + 0.43379 * g);
    return g < 2.0 ? 1.0 : 0.20924 + 0.39538 * g;
  }
  /// a of the branches, so that (1 - e^(-2a))/a = 1 - pi h_eq/(2 u), at most its limit.
  [[nodiscard]] double decay(double g) const {
    const double limit = kind == Kind::x06 ? 10.19171 : 12.5603;
    const double share = hysteretic_share(g), ratio = 1.0 - std::numbers::pi * damping_ratio(g) / (2.0 * share);
    if (ratio <= -std::expm1(-2.0 * limit) / limit) return limit;
    // (1 - e^(-2a))/a falls from 2 to 0: Newton's method from its large-a limit, bounded.
    double a = std::min(1.0 / ratio, limit);
    constexpr int most_iterations = 50;
    for (int i = 0; i < most_iterations; ++i) {
      const double value = -std::expm1(-2.0 * a) / a, slope = (2.0 * std::exp(-2.0 * a) - value) / a;
      const double next = std::clamp(a - (value - ratio) / slope, 0.1 * a, limit);
      const bool settled = std::abs(next - a) < 1e-15 * a;
      a = next;
      if (settled) break;
    }
    return a;
  }

  /// c and b of the branches: b adds the damping that a at its limit leaves at large strain.
  [[nodiscard]] double second_decay() const { return kind == Kind::x06 ? 5.0 : 5.5; }
  /// B, 1, >= 0.
  [[nodiscard]] double second_size(double g) const {
    if (g <= (kind == Kind::x06 ? 1.4 : 1.5)) return 0.0;
    const double a = decay(g), c = second_decay();
    return c * c * (std::numbers::pi * damping_ratio(g) / hysteretic_share(g) - (2.0 + 2.0 / a * std::expm1(-2.0 * a)));
  }
  /// The strain where the fit of G_eq changes.
  [[nodiscard]] double change_of_fit() const { return kind == Kind::x06 ? 1.15 : 2.0; }
  /// G_eq g and its slope over g, N/m^2.
  [[nodiscard]] double skeleton(double g) const {
    if (g > largest_strain) {
      return shear_modulus(largest_strain) * largest_strain + skeleton_slope(largest_strain) * (g - largest_strain);
    }
    return shear_modulus(g) * g;
  }
  /// Slope of the skeleton over g, N/m^2.
  [[nodiscard]] double skeleton_slope(double g) const {
    g = std::min(g, largest_strain);
    if (kind == Kind::x06)
      return 1e6 * (g < 1.15 ? 0.60036 * 0.68358 * std::pow(g, -0.39964)
                             : 1.10103 + g * (-2.0 * 0.61946 + g * (3.0 * 0.22047 - 4.0 * 0.022191 * g)));
    return 1e6 *
           (g < 2.0 ? 0.57948 * 0.38073 * std::pow(g, -0.42052) : 0.46499 + g * (-2.0 * 0.12723 + 3.0 * 0.0184823 * g));
  }
  /// The integral of the skeleton over g, N/m^2, in parts where its fit changes.
  [[nodiscard]] double skeleton_work(double from, double to) const {
    const bool x06 = kind == Kind::x06;
    const double change = change_of_fit();
    const auto power = [&](double g) {
      return 1e6 * (x06 ? 0.68358 * std::pow(g, 1.60036) / 1.60036 : 0.38073 * std::pow(g, 1.57948) / 1.57948);
    };
    const auto polynomial = [&](double g) {
      return 1e6 * g * g *
             (x06 ? 1.10103 / 2.0 + g * (-0.61946 / 3.0 + g * (0.22047 / 4.0 - 0.022191 / 5.0 * g))
                  : 0.46499 / 2.0 + g * (-0.12723 / 3.0 + 0.0184823 / 4.0 * g));
    };
    double sum = 0.0;
    if (from < change) sum += power(std::min(to, change)) - power(from);
    if (to > change && from < largest_strain)
      sum += polynomial(std::min(to, largest_strain)) - polynomial(std::max(from, change));
    if (to > largest_strain) {
      const double start = std::max(from, largest_strain);
      sum += 0.5 * (skeleton(start) + skeleton(to)) * (to - start);
    }
    return sum;
  }
};

}  // namespace moat
