#include "performance/error_curve.hpp"

#include <algorithm>
#include <cmath>

namespace moat::performance {

std::vector<CurvePoint> with_lasting_errors(std::vector<CurvePoint> points) {
  double largest = 0.0;
  for (auto point = points.rbegin(); point != points.rend(); ++point)
    point->error = largest = std::max(largest, point->error);
  return points;
}

std::vector<CurvePoint> lower_envelope(std::vector<CurvePoint> points) {
  std::sort(points.begin(), points.end(),
            [](const CurvePoint& a, const CurvePoint& b) { return a.seconds < b.seconds; });
  std::vector<CurvePoint> envelope;
  for (const CurvePoint& point : points)
    if (envelope.empty() || point.error < envelope.back().error) envelope.push_back(point);
  return envelope;
}

double ReadOff::time(double of_looser, double of_tighter) const {
  return std::exp(std::lerp(std::log(of_looser), std::log(of_tighter), share));
}

std::optional<ReadOff> read_off(const std::vector<CurvePoint>& points, double error) {
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
