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
  double low, high;
};
/// standard_deviation > 0.
struct NormalDistribution {
  double mean, standard_deviation;
};
/// ln x is normal with mean ln median and standard deviation `dispersion`; both > 0.
struct LognormalDistribution {
  double median, dispersion;
};

/// A parameter with a distribution; its numbers are in `unit`.
struct RandomVariable {
  std::string name;
  std::string unit;
  std::variant<UniformDistribution, NormalDistribution, LognormalDistribution> distribution;
};

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
