// One loop of high-damping rubber: its elastic part and the branches between reversals.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/rubber_compound.hpp"

namespace moat {

/// The loop at one largest strain g_m, over x = g/g_m (materials/isolation/kikuchi_aiken_rubber.hpp has the equations).
/// Stresses are in N/m^2.
struct RubberLoop {
  double largest = 1.0;                          ///< g_m
  double skeleton = 0.0;                         ///< f_m
  double share = 0.0;                            ///< u
  double exponent = 1.0;                         ///< n
  double decay = 1.0;                            ///< a
  double second_size = 0.0, second_decay = 1.0;  ///< b, c

  /// A stress and its slope over the strain.
  struct Stress {
    double value, slope;  ///< N/m^2, both
  };
  /// A turn of the deformation.
  struct Reversal {
    double x = 0.0, q = 0.0;      ///< q = Q2/f_m
    double alpha = 1.0, b = 0.0;  ///< of the branch that begins here
    friend bool operator==(const Reversal&, const Reversal&) = default;
  };
  /// A branch at the distance X from its reversal, over alpha u f_m: value, slope and integral over X.
  struct Branch {
    double value, slope, integral;  ///< without unit
  };

  /// Returns the loop of a compound with this largest strain.
  static RubberLoop at(const RubberCompound& rubber, double largest) {
    const double g = std::min(largest, RubberCompound::largest_strain);
    return {.largest = largest,
            .skeleton = rubber.skeleton(largest),
            .share = rubber.hysteretic_share(g),
            .exponent = rubber.elastic_exponent(g),
            .decay = rubber.decay(g),
            .second_size = rubber.second_size(g),
            .second_decay = rubber.second_decay()};
  }

  /// Q1.
  [[nodiscard]] Stress elastic(double x) const {
    const double size = std::abs(x);
    return {0.5 * (1.0 - share) * skeleton * (x + std::copysign(std::pow(size, exponent), x)),
            0.5 * (1.0 - share) * skeleton * (1.0 + exponent * std::pow(size, exponent - 1.0)) / largest};
  }
  /// Returns the integral of the elastic force over the strain, from 0.
  [[nodiscard]] double elastic_energy(double x) const {
    const double size = std::abs(x);
    return 0.5 * (1.0 - share) * skeleton * largest *
           (0.5 * size * size + std::pow(size, exponent + 1.0) / (exponent + 1.0));
  }
  /// Returns the values of a branch with this b.
  [[nodiscard]] Branch branch(double b, double distance) const {
    const double c = second_decay, first = std::exp(-decay * distance), second = std::exp(-c * distance);
    return {
        2.0 - 2.0 * first + b * distance * second, 2.0 * decay * first + b * (1.0 - c * distance) * second,
        2.0 * distance + 2.0 / decay * (first - 1.0) + b * (1.0 / (c * c) - second * (distance / c + 1.0 / (c * c)))};
  }
  /// Slope over the strain of the branch that begins at a reversal, there.
  [[nodiscard]] double first_slope(const Reversal& from) const {
    return from.alpha * share * skeleton * branch(from.b, 0.0).slope / largest;
  }
  /// Q2/f_m at x on the branch that leads in a direction from a reversal.
  [[nodiscard]] double hysteretic(const Reversal& from, double x, int direction) const {
    return from.q + direction * from.alpha * share * branch(from.b, std::abs(x - from.x)).value;
  }
  /// Where a branch that began at `before` turns at x: the next one meets `before` again.
  [[nodiscard]] Reversal turned(const Reversal& before, double x, double q) const {
    Reversal next{.x = x, .q = q, .b = before.x * x >= 0.0 ? 0.0 : before.b};
    const double distance = std::abs(before.x - x);
    next.alpha = before.alpha;
    if (distance > 0.0) next.alpha *= branch(before.b, distance).value / branch(next.b, distance).value;
    return next;
  }
  /// The integral of the stress over the strain along a branch from x = start to x = end.
  [[nodiscard]] double work(const Reversal& from, double start, double end) const {
    const double of_branch =
        branch(from.b, std::abs(end - from.x)).integral - branch(from.b, std::abs(start - from.x)).integral;
    return elastic_energy(end) - elastic_energy(start) +
           largest * skeleton * (from.q * (end - start) + from.alpha * share * of_branch);
  }
};

}  // namespace moat
