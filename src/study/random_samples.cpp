#include "study/random_samples.hpp"

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <random>
#include <utility>

#include "base/check.hpp"

namespace moat {
namespace {

// The distributions of the standard library differ between its implementations; its generators do not.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : generator_{seed} {}

  /// In (0, 1).
  double share() {
    constexpr int unused_bits = 11;
    constexpr double spacing = 0x1p-53;
    return (static_cast<double>(generator_() >> unused_bits) + 0.5) * spacing;
  }
  /// From 0 to bound - 1.
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(share() * static_cast<double>(bound)); }

 private:
  std::mt19937_64 generator_;
};

double normal_quantile(double share) { return boost::math::quantile(boost::math::normal_distribution<>{}, share); }

struct Quantile {
  double share;
  double operator()(const UniformDistribution& each) const { return each.low + share * (each.high - each.low); }
  double operator()(const NormalDistribution& each) const {
    return each.mean + each.standard_deviation * normal_quantile(share);
  }
  double operator()(const LognormalDistribution& each) const {
    return each.median * std::exp(each.dispersion * normal_quantile(share));
  }
};

struct Checked {
  Check check;
  std::string unit;
  void operator()(const UniformDistribution& each) const {
    check.finite("low", each.low, unit);
    check.finite("high", each.high, unit);
    check.that(each.low < each.high, "low is not below high.", "Give the lower end first.");
  }
  void operator()(const NormalDistribution& each) const {
    check.finite("mean", each.mean, unit);
    check.positive("standard_deviation", each.standard_deviation, unit);
  }
  void operator()(const LognormalDistribution& each) const {
    check.positive("median", each.median, unit);
    check.positive("dispersion", each.dispersion, "1");
  }
};

// Shares of probability, one for each sample.
std::vector<double> shares(Draws& draws, std::size_t count, Sampling sampling) {
  std::vector<double> list(count);
  if (sampling == Sampling::independent) {
    for (double& share : list) share = draws.share();
    return list;
  }
  for (std::size_t i = 0; i < count; ++i)
    list[i] = (static_cast<double>(i) + draws.share()) / static_cast<double>(count);
  for (std::size_t i = count; i > 1; --i) std::swap(list[i - 1], list[draws.below(i)]);
  return list;
}

}  // namespace

StudyCases random_samples(const std::vector<RandomVariable>& variables, int count, std::uint64_t seed,
                          Sampling sampling) {
  Check{"random_samples", ""}.that(count >= 1, "count", count, "1", ">= 1");
  Draws draws{seed};
  std::vector<StudyAxis> axes;
  for (const RandomVariable& variable : variables) {
    std::visit(Checked{Check{"RandomVariable", variable.name}, variable.unit}, variable.distribution);
    StudyAxis axis{.name = variable.name, .unit = variable.unit, .values = {}};
    for (const double share : shares(draws, static_cast<std::size_t>(count), sampling))
      axis.values.push_back(std::visit(Quantile{share}, variable.distribution));
    axes.push_back(std::move(axis));
  }
  return StudyCases::list(std::move(axes));
}

}  // namespace moat
