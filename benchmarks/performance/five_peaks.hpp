// The peaks by which everyone is judged.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "performance/parabola_peak.hpp"

namespace moat::performance {

/// Base and top displacement (m), base and top absolute acceleration (m/s^2), impact force (N).
using Peaks = std::array<double, 5>;

inline double largest_error(const Peaks& peaks, const Peaks& reference) {
  double worst = 0.0;
  for (std::size_t i = 0; i < peaks.size(); ++i) worst = std::max(worst, std::abs(peaks[i] / reference[i] - 1.0));
  return std::isfinite(worst) ? worst : 1e9;
}

/// Follows the five over continuous time by samples alone: for the peers, who have no rates.
class FivePeaks {
 public:
  void add(double time, const Peaks& now) {
    for (std::size_t i = 0; i < now.size(); ++i) trackers_[i].add(time, now[i]);
  }
  /// Just after an event.
  void restart(double time, const Peaks& now) {
    for (std::size_t i = 0; i < now.size(); ++i) trackers_[i].restart(time, now[i]);
  }
  [[nodiscard]] Peaks values() const {
    Peaks peaks{};
    for (std::size_t i = 0; i < peaks.size(); ++i) peaks[i] = trackers_[i].magnitude();
    return peaks;
  }

 private:
  std::array<ParabolaPeak, 5> trackers_;
};

}  // namespace moat::performance
