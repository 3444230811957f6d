#include "analyses/hidden_motion.hpp"

#include <algorithm>
#include <cmath>

namespace moat {

bool hides_motion(const Model& model, const StepTask& step, double margin) {
  if (!step.ground) return false;
  constexpr double negligible = 1e-4;  // of the displacement
  const double displacement = std::max(model.state().displacement.lpNorm<Eigen::Infinity>(),
                                       model.trial().displacement.lpNorm<Eigen::Infinity>());
  const double harmless = std::min(negligible * displacement, 0.5 * margin);  // m
  if (step.ground->bump_bounds().displacement <= harmless) return false;
  double bump = 0.0;  // m
  step.ground->for_each_bump_inside([&](const GroundBump& b) { bump = std::max(bump, std::abs(b.displacement)); });
  return bump > harmless;
}

}  // namespace moat
