#include "analyses/hidden_motion.hpp"

#include <algorithm>
#include <cmath>

namespace moat {

bool hides_motion(const StepSolver& step, const StepGrid& grid, double h, double margin) {
  const MotionState &start = step.model().state(), &end = step.model().trial();
  const GroundSpan span = grid.span(start.time, end.time);
  if (span.is_straight()) return false;
  constexpr double negligible = 1e-4;  // of the displacement
  double bump = 0.0;                   // m
  span.for_each_bump_inside([&](const GroundBump& b) { bump = std::max(bump, std::abs(b.displacement)); });
  const double displacement =
      std::max(start.displacement.lpNorm<Eigen::Infinity>(), end.displacement.lpNorm<Eigen::Infinity>());
  return bump > negligible * displacement || 2.0 * bump > std::min(margin, step.scan(h).margin);
}

}  // namespace moat
