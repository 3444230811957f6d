// How the links of a block deform over a step.
#pragma once

#include <cstddef>
#include <vector>

#include "base/hermite.hpp"

namespace moat {

/// Deformation of every link of a block at one instant, with its first two rates: m, m/s, m/s^2.
struct LinkMotion {
  std::vector<double> deformations, rates, second_rates;  ///< m, m/s, m/s^2

  /// Changes the size of all three; new entries are zero.
  void resize(std::size_t count) {
    for (auto* values : {&deformations, &rates, &second_rates}) values->resize(count, 0.0);
  }
  /// As an assignment between motions of equally many links, without three calls for the few links of most blocks.
  void copy(const LinkMotion& other) {
    const double *deformation = other.deformations.data(), *rate = other.rates.data(),
                 *second_rate = other.second_rates.data();
    double* __restrict own_deformation = deformations.data();
    double* __restrict own_rate = rates.data();
    double* __restrict own_second_rate = second_rates.data();
    const std::size_t count = deformations.size();
    for (std::size_t i = 0; i < count; ++i) {
      own_deformation[i] = deformation[i];
      own_rate[i] = rate[i];
      own_second_rate[i] = second_rate[i];
    }
  }
  /// Exchanges all three.
  void swap(LinkMotion& other) {
    deformations.swap(other.deformations);
    rates.swap(other.rates);
    second_rates.swap(other.second_rates);
  }
};

/// The deformation of one link from one instant to another, `step` s later, through value and both rates.
inline HermiteQuintic path_between(const LinkMotion& start, const LinkMotion& end, std::size_t link, double step) {
  return {start.deformations[link],
          start.rates[link],
          start.second_rates[link],
          end.deformations[link],
          end.rates[link],
          end.second_rates[link],
          step};
}

/// The deformation of one link between the same instants, through value and rate alone.
inline HermiteCubic cubic_between(const LinkMotion& start, const LinkMotion& end, std::size_t link, double step) {
  return {start.deformations[link], start.rates[link], end.deformations[link], end.rates[link], step};
}

}  // namespace moat
