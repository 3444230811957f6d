// Random numbers that are the same with every compiler and standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace moat::testing {

/// To so many significant decimal digits: a last bit that differs between machines does not survive it.
inline double rounded(double value, int digits = 4) {
  if (value == 0.0) return 0.0;
  const int place = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  const double scale = std::pow(10.0, std::abs(place));
  return place >= 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

/// The standard library fixes the engine, not the distributions.
class RandomDraws {
 public:
  explicit RandomDraws(std::uint64_t seed) : engine_{seed} {}

  /// 0 <= x < 1.
  double unit() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }
  double uniform(double low, double high) { return rounded(low + (high - low) * unit()); }
  /// Every decade is as likely.
  double decades(double low, double high) { return rounded(low * std::pow(high / low, unit())); }
  /// low <= n <= high.
  int integer(int low, int high) { return low + static_cast<int>(unit() * (high - low + 1)); }
  bool chance(double probability) { return unit() < probability; }
  /// Zero mean and unit variance: the sum of twelve numbers is close enough to normal for a ground motion.
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += unit();
    return sum;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace moat::testing
