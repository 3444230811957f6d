// Error against CPU time, and the cost of a given error.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace moat::performance {

/// One setting of a candidate, run.
struct CurvePoint {
  std::size_t setting = 0;
  double error = 0.0, seconds = 0.0;
};

/// The cost of an error: time^(1 - share) of `looser` times time^share of `tighter`, which is a straight line in a
/// log-log chart.
struct ReadOff {
  std::size_t looser = 0, tighter = 0;  ///< settings
  double share = 0.0;
  bool always_better = false;  ///< no setting is that bad: the cheapest counts, and both settings are it

  /// Returns the time between those of both settings, s.
  [[nodiscard]] double time(double of_looser, double of_tighter) const {
    return std::exp(std::lerp(std::log(of_looser), std::log(of_tighter), share));
  }
};

/// `points`: settings that differ in one thing, from the loosest to the tightest. Between the first setting from which
/// on all keep to the error and the one before it, which does not: a setting that is exact by chance gains nothing.
/// Empty if the tightest does not.
inline std::optional<ReadOff> read_off(const std::vector<CurvePoint>& points, double error) {
  const auto too_bad =
      std::find_if(points.rbegin(), points.rend(), [&](const CurvePoint& p) { return p.error > error; });
  if (too_bad == points.rbegin()) return std::nullopt;
  if (too_bad == points.rend()) {
    const auto cheapest = std::min_element(
        points.begin(), points.end(), [](const CurvePoint& a, const CurvePoint& b) { return a.seconds < b.seconds; });
    return ReadOff{cheapest->setting, cheapest->setting, 0.0, true};
  }
  const CurvePoint &looser = *too_bad, &tighter = *(too_bad - 1);
  return ReadOff{looser.setting, tighter.setting,
                 std::log(looser.error / error) / std::log(looser.error / tighter.error), false};
}

}  // namespace moat::performance
