// How the links of a block deform over a step.
#pragma once

#include <cstddef>
#include <vector>

#include "base/hermite.hpp"
#include "base/plan_vector.hpp"

namespace moat {

/// Deformation of every link of a block at one instant, with its first two rates: m, m/s, m/s^2.
template <class Vector>
struct LinkMotion {
  std::vector<Vector> deformations, rates, second_rates;  ///< m, m/s, m/s^2

  /// Changes the size of all three; new entries are zero.
  void resize(std::size_t count) {
    for (auto* values : {&deformations, &rates, &second_rates}) values->resize(count, Vector{});
  }
  void archive(auto& archive) { archive(deformations, rates, second_rates); }  ///< StateArchive.
};

/// The axial forces of all links of a block at one instant; empty for laws that take none.
struct LinkCompressions {
  std::vector<double> values, rates;  ///< N, N/s; compression positive

  /// Changes the size of both; new entries are zero.
  void resize(std::size_t count) {
    for (auto* each : {&values, &rates}) each->resize(count, 0.0);
  }
  void archive(auto& archive) { archive(values, rates); }  ///< StateArchive.
};

/// The compression of one link from one instant to another, `step` s later.
inline HermiteCubic compression_between(const LinkCompressions& start, const LinkCompressions& end, std::size_t link,
                                        double step) {
  return {start.values[link], start.rates[link], end.values[link], end.rates[link], step};
}

/// The deformation in plan over a step, through value and both rates at its ends.
struct PlanPath {
  HermiteQuintic x, y;  ///< its components

  [[nodiscard]] PlanVector value(double fraction) const { return {x.value(fraction), y.value(fraction)}; }  ///< m
  [[nodiscard]] PlanVector rate(double fraction) const { return {x.rate(fraction), y.rate(fraction)}; }     ///< m/s
};

/// The deformation of one link from one instant to another, `step` s later, through value and both rates.
inline HermiteQuintic path_between(const LinkMotion<double>& start, const LinkMotion<double>& end, std::size_t link,
                                   double step) {
  return {start.deformations[link],
          start.rates[link],
          start.second_rates[link],
          end.deformations[link],
          end.rates[link],
          end.second_rates[link],
          step};
}
/// Returns the path of a link in plan.
inline PlanPath path_between(const LinkMotion<PlanVector>& start, const LinkMotion<PlanVector>& end, std::size_t link,
                             double step) {
  const PlanVector d0 = start.deformations[link], v0 = start.rates[link], a0 = start.second_rates[link],
                   d1 = end.deformations[link], v1 = end.rates[link], a1 = end.second_rates[link];
  return {{d0.x, v0.x, a0.x, d1.x, v1.x, a1.x, step}, {d0.y, v0.y, a0.y, d1.y, v1.y, a1.y, step}};
}

/// The deformation of one link between the same instants, through value and rate alone.
inline HermiteCubic cubic_between(const LinkMotion<double>& start, const LinkMotion<double>& end, std::size_t link,
                                  double step) {
  return {start.deformations[link], start.rates[link], end.deformations[link], end.rates[link], step};
}

/// Fraction at which the deformation turns, or is slowest, inside a step with these rates at its ends; 0 if it does
/// not. A linear rate is exact for average acceleration, and close enough for others to decide whether to look there.
inline double turning_point(double start_rate, double end_rate) {
  return start_rate * end_rate < 0.0 ? start_rate / (start_rate - end_rate) : 0.0;
}
/// Returns the fraction at which a motion in plan turns.
inline double turning_point(PlanVector start_rate, PlanVector end_rate) {
  const PlanVector change = end_rate - start_rate;
  const double turn = -dot(start_rate, change) / dot(change, change);
  return turn > 0.0 && turn < 1.0 ? turn : 0.0;
}

}  // namespace moat
