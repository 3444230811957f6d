#include "performance/error_curve.hpp"

#include <algorithm>
#include <cmath>

namespace moat::performance {

std::vector<CurvePoint> lower_envelope(std::vector<CurvePoint> points) {
  std::sort(points.begin(), points.end(),
            [](const CurvePoint& a, const CurvePoint& b) { return a.seconds < b.seconds; });
  std::vector<CurvePoint> envelope;
  for (const CurvePoint& point : points)
    if (envelope.empty() || point.error < envelope.back().error) envelope.push_back(point);
  return envelope;
}

double ReadOff::time(double of_cheaper, double of_dearer) const {
  return std::exp(std::lerp(std::log(of_cheaper), std::log(of_dearer), share));
}

std::optional<ReadOff> read_off(const std::vector<CurvePoint>& envelope, double error) {
  const auto enough =
      std::find_if(envelope.begin(), envelope.end(), [&](const CurvePoint& point) { return point.error <= error; });
  if (enough == envelope.end()) return std::nullopt;
  if (enough == envelope.begin()) return ReadOff{enough->setting, enough->setting, 0.0, true};
  const CurvePoint& before = *(enough - 1);
  return ReadOff{before.setting, enough->setting,
                 std::log(before.error / error) / std::log(before.error / enough->error), false};
}

}  // namespace moat::performance
