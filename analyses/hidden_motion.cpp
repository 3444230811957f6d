#include "analyses/hidden_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/building.hpp"

namespace moat {

HiddenMotion::HiddenMotion(const Model& model) : building_{connected_parts(model)} {
  largest_.setConstant(model.degrees_of_freedom(), std::numeric_limits<double>::infinity());
  for (const int building : building_) largest_[building] = 0.0;
}

bool HiddenMotion::in(const StepTask& step, const Model& model, double margin) {
  if (!step.ground) return false;
  const Vector& displacement = model.state().displacement;
  for (Eigen::Index i = 0; i < largest_.size(); ++i) {
    double& largest = largest_[building_[static_cast<std::size_t>(i)]];
    // Written seldom: each look would wait for the last write.
    if (const double size = std::abs(displacement[i]); size > largest) largest = size;
  }
  const double harmless = std::min(negligible_bump(), share_of_margin * margin);
  if (step.ground->bump_bounds().displacement <= harmless) return false;
  double bump = 0.0;  // m
  step.ground->for_each_bump_inside([&](const GroundBump& b) { bump = std::max(bump, std::abs(b.displacement)); });
  return bump > harmless;
}

}  // namespace moat
