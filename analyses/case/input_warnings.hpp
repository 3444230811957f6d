// Warnings about the motion and the model of a run, before any result.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// An acceleration of the ground beyond all records, and a vertical record that shakes the model horizontally.
std::vector<std::string> motion_warnings(const GroundMotion& motion);

/// Isolators whose strength is above 30 % of the weight on them, so that they hardly ever slide or yield, and isolators
/// that are made for another weight. Gaps whose left side is drawn to the right of their right side; in plan, corners
/// that can jam, and bearings and centres of mass outside the outline of their floor.
std::vector<std::string> model_warnings(const Model& model);

/// First periods of buildings held at their base that are above 10 s or below 0.02 s: the unit of a
/// stiffness or a mass is another one.
std::vector<std::string> period_warnings(const Model& model);

}  // namespace moat
