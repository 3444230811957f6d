// Parameters drawn at random.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "study/cases.hpp"

namespace moat {

/// Equal density from low to high; low < high.
struct UniformDistribution {
  /// Ends of the interval.
  double low, high;
};
/// standard_deviation > 0.
struct NormalDistribution {
  /// Mean and standard deviation of the values; the deviation > 0.
  double mean, standard_deviation;
};
/// ln x is normal with mean ln median and standard deviation `dispersion`; both > 0.
struct LognormalDistribution {
  /// Median of the values, > 0; dispersion: standard deviation of their logarithm.
  double median, dispersion;
};

/// A parameter with a distribution; its numbers are in `unit`.
struct RandomVariable {
  std::string name;  ///< Name of the axis.
  std::string unit;  ///< Unit of its values.
  std::variant<UniformDistribution, NormalDistribution, LognormalDistribution>
      distribution;  ///< Distribution of the values.
};

/// How samples are drawn.
enum class Sampling {
  independent,  ///< every sample for itself
  /// Every variable has exactly one sample in each of `count` intervals of equal probability (McKay, Beckman & Conover
  /// 1979); the intervals of different variables are paired at random.
  latin_hypercube,
};

/// `count` >= 1 samples of all variables as cases of one group. Equal seeds give equal numbers on every machine.
/// Throws InputError for a parameter outside its range.
StudyCases random_samples(const std::vector<RandomVariable>& variables, int count, std::uint64_t seed,
                          Sampling sampling = Sampling::latin_hypercube);

}  // namespace moat
