#include "analyses/hidden_motion.hpp"

#include <algorithm>
#include <cmath>

#include "model/building.hpp"

namespace moat {

HiddenMotion::HiddenMotion(const Model& model) : building_{connected_parts(model)} {
  largest_.setZero(std::ranges::max(building_) + 1);
}

bool HiddenMotion::in(const StepTask& step, const Model& model, double margin) {
  if (!step.ground) return false;
  const Vector& displacement = model.state().displacement;
  for (std::size_t i = 0; i < building_.size(); ++i) {
    double& largest = largest_[building_[i]];
    // Written seldom: each look would wait for the last write.
    if (const double size = std::abs(displacement[static_cast<Eigen::Index>(i)]); size > largest) largest = size;
  }
  const double harmless = std::min(negligible_bump(), share_of_margin * margin);
  if (step.ground->bump_bounds().displacement <= harmless) return false;
  double bump = 0.0;  // m
  step.ground->for_each_bump_inside([&](const GroundBump& b) { bump = std::max(bump, std::abs(b.displacement)); });
  return bump > harmless;
}

}  // namespace moat
