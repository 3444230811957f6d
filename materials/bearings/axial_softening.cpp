#include "materials/bearings/axial_softening.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.hpp"

namespace moat {
namespace {

// The derivative of the overlap, 1/m; along an axis that the displacement does not leave, none.
PlanVector overlap_slope(const RubberBearing& rubber, PlanVector d) {
  if (rubber.is_round()) {
    const double size = length(d), share = size / rubber.diameter.si();
    if (size == 0.0 || share >= 1.0) return {};
    return -4.0 / std::numbers::pi * std::sqrt(1.0 - share * share) / (rubber.diameter.si() * size) * d;
  }
  const double width_x = rubber.width_x.si(), width_y = rubber.width_y.si();
  if (std::abs(d.x) >= width_x || std::abs(d.y) >= width_y) return {};
  const auto slope = [](double value, double width) { return value == 0.0 ? 0.0 : std::copysign(1.0 / width, -value); };
  return {slope(d.x, width_x) * (1.0 - std::abs(d.y) / width_y), slope(d.y, width_y) * (1.0 - std::abs(d.x) / width_x)};
}

}  // namespace

AxialSoftening::AxialSoftening(const RubberBearing& rubber, double compression, PlanVector farthest) {
  const double at_rest = rubber.critical_load().si(),
               overlap = rubber.overlap(farthest.x * units::m, farthest.y * units::m),
               share = RubberBearing::critical_share(overlap);
  critical_load = share * at_rest;
  // The part that remains at any displacement does not fall.
  if (share == overlap) critical_slope = at_rest * overlap_slope(rubber, farthest);
  if (compression <= 0.0) return;
  constexpr double least = 0.01;
  const double ratio = compression / critical_load;
  factor = std::max(least, 1.0 - ratio * ratio);
  if (factor == least) return;
  by_compression = -2.0 * ratio / critical_load;
  by_displacement = 2.0 * ratio * ratio / critical_load * critical_slope;
}

}  // namespace moat
