// The peaks by which all methods are judged.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/error.hpp"
#include "output/files/case_result.hpp"

namespace moat::performance {

/// Base and top displacement (m), base and top absolute acceleration (m/s^2), impact force (N).
using Peaks = std::array<double, 5>;

/// The magnitude of a peak. Throws InputError where the result has none of this quantity and place.
inline double peak_of(const CaseResult& result, std::string_view quantity, std::string_view where) {
  for (const Peak& peak : result.peaks)
    if (peak.quantity == quantity && peak.where == where) return peak.magnitude();
  throw InputError{"There is no peak " + std::string{quantity} + " of " + std::string{where} + "."};
}

/// The largest relative error; very large where a peak is no number.
template <std::size_t count>
double largest_error(const std::array<double, count>& peaks, const std::array<double, count>& reference) {
  constexpr double useless = 1e9;
  double worst = 0.0;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    const double error = std::abs(peaks[i] / reference[i] - 1.0);
    if (!std::isfinite(error)) return useless;
    worst = std::max(worst, error);
  }
  return worst;
}

/// Follows the five through instants at unequal distances by samples alone, for methods that have no rates, and keeps
/// their largest magnitudes over continuous time: where neighbouring samples turn, the vertex of the parabola through
/// three of them counts.
class FivePeaks {
 public:
  void add(double time, const Peaks& now) {
    for (std::size_t i = 0; i < now.size(); ++i) {
      peaks_[i] = std::max(peaks_[i], std::abs(now[i]));
      if (count_ >= 2 && (last_[i] - before_[i]) * (now[i] - last_[i]) < 0.0) keep_vertex(i, time, now[i]);
    }
    before_ = last_;
    time_before_ = last_time_;
    last_ = now;
    last_time_ = time;
    ++count_;
  }
  /// Just after an event, where quantities may jump: no parabola reaches across it.
  void restart(double time, const Peaks& now) {
    count_ = 0;
    add(time, now);
  }
  [[nodiscard]] const Peaks& values() const { return peaks_; }

 private:
  void keep_vertex(std::size_t i, double time, double value) {
    const double before = last_time_ - time_before_, after = time - last_time_;
    if (before <= 0.0 || after <= 0.0) return;
    const double slope_before = (last_[i] - before_[i]) / before, slope_after = (value - last_[i]) / after;
    const double curvature = (slope_after - slope_before) / (before + after);
    const double slope = (slope_before * after + slope_after * before) / (before + after);
    peaks_[i] = std::max(peaks_[i], std::abs(last_[i] - 0.25 * slope * slope / curvature));
  }

  Peaks peaks_{}, last_{}, before_{};
  double last_time_ = 0.0, time_before_ = 0.0;
  int count_ = 0;
};

}  // namespace moat::performance
