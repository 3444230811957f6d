#include "analyses/case/input_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "analyses/modes/periods.hpp"
#include "base/check.hpp"
#include "base/units.hpp"
#include "model/building.hpp"
#include "motions/readers/read_motion.hpp"

namespace moat {
namespace {

// Bearings in plan that do not stand under their floor.
std::vector<std::string> bearings_outside(const Model& model) {
  std::vector<std::string> warnings;
  for (const auto& block : model.blocks()) {
    for (std::size_t e = 0; e < block->size(); ++e) {
      const ElementInfo& info = block->info(e);
      if (!info.acts_in_two_directions()) continue;
      const PlacedDiaphragm* floor = model.diaphragm_of(info.second);
      const PlanVector at = info.plan_places()->second;
      if (!info.isolates || floor == nullptr || floor->outline.empty() || floor->outline.contains(at)) continue;
      warnings.push_back("Bearing \"" + info.name + "\" at (" + to_text(at.x) + ", " + to_text(at.y) +
                         ") m is outside the outline of \"" + floor->name + "\". Correct its position or the outline.");
    }
  }
  return warnings;
}

// Centres of mass that do not lie on their floor.
std::vector<std::string> centres_outside(const Model& model) {
  std::vector<std::string> warnings;
  for (const PlacedDiaphragm& floor : model.diaphragms()) {
    const PlanVector at = floor.centre_of_mass;
    if (!floor.outline.empty() && !floor.outline.contains(at))
      warnings.push_back("The centre of mass of \"" + floor.name + "\" at (" + to_text(at.x) + ", " + to_text(at.y) +
                         ") m is outside its outline. Correct the centre of mass, its offset or the outline.");
  }
  return warnings;
}

// N: the force at zero deformation after yielding, as the parameters of a law give it; 0 for a law without one.
double strength_of(const LawAsGiven& law) {
  const double of_yield =
      parameter_of(law.parameters, "yield_force") -
      parameter_of(law.parameters, "post_yield_stiffness") * parameter_of(law.parameters, "yield_displacement");
  return parameter_of(law.parameters, "strength", parameter_of(law.parameters, "characteristic_strength", of_yield));
}

// Isolators that are too strong for the weight on them, or that were given another weight.
std::vector<std::string> doubtful_isolators(const Model& model) {
  constexpr double usual = 0.3, tolerated = 0.05, unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::string> warnings;
  const std::vector<Building>& buildings = model.buildings();
  const std::vector<std::vector<ElementId>> isolators = isolators_of(model, buildings);
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    double strength = 0.0, mass = 0.0, designed = 0.0;
    for (const ElementId id : isolators[b]) {
      const ElementBlock& block = *model.blocks()[id.block];
      const LawAsGiven law = block.law_of_block(id.element), given = block.law(id.element);
      const double count = parameter_of(law.parameters, "count", 1.0);
      strength += count * strength_of(law);
      designed += count * parameter_of(given.parameters, "weight", unknown);
    }
    if (isolators[b].empty()) continue;
    for (const NodeId node : carried_nodes(model, buildings[b])) mass += model.mass(node);
    const std::string isolators_of_it =
        "The isolators of " + (buildings[b].name.empty() ? "the building" : buildings[b].name);
    const double weight = mass * standard_gravity, share = strength / weight;
    if (std::abs(designed / weight - 1.0) > tolerated)
      warnings.push_back(isolators_of_it + " are made for a weight of " + to_text(1e-3 * designed) + " kN, and " +
                         to_text(1e-3 * weight) +
                         " kN stand on them. Give their .weight; under a base that carries buildings added later, "
                         "SuperstructureBase::carried.");
    if (share > usual)
      warnings.push_back(isolators_of_it + " have a strength of " + to_text(std::round(1000.0 * share) / 10.0) +
                         " % of the weight on them; 3 to 10 % is usual, and above 30 % they hardly ever yield. Check "
                         "the units of yield_force, strength and masses.");
  }
  return warnings;
}

// Corners that friction can press into their edge without an end.
std::vector<std::string> jamming_corners(const Model& model) {
  std::vector<std::string> warnings;
  for (const auto& block : model.blocks()) {
    for (std::size_t e = 0; e < block->size(); ++e)
      if (const CornerPair* pair = block->info(e).corner_pair(); pair != nullptr && pair->may_jam)
        warnings.push_back("\"" + block->info(e).name +
                           "\" can jam: while its corner slides, friction presses it into the edge at least as hard as "
                           "the contact pushes it back, 1/m_n <= mu |m_nt|. Give less friction, or check the rotary "
                           "inertia and the place of the corner.");
  }
  return warnings;
}

}  // namespace

std::vector<std::string> motion_warnings(const GroundMotion& motion) {
  constexpr double strongest = 5.0 * standard_gravity;  // the strongest records reach about 4 g
  const double peak = motion.peak_acceleration().si();
  std::vector<std::string> warnings;
  for (const std::string& note : motion.notes())
    if (note.find(vertical_record) != std::string::npos)
      warnings.push_back(note + " It shakes the model horizontally. Give a horizontal component.");
  if (peak <= strongest) return warnings;
  std::string factors;
  for (const MotionComponent& component : motion.components())
    factors += (factors.empty() ? "" : " and ") + to_text(component.scale_factor);
  warnings.push_back("The peak acceleration of the ground is " + to_text(peak / standard_gravity) +
                     " g; no record is as strong as 5 g. Check the unit of the record and its scale factor (" +
                     factors + ").");
  return warnings;
}

std::vector<std::string> model_warnings(const Model& model) {
  std::vector<std::string> warnings = doubtful_isolators(model);
  if (model.is_plan()) {
    for (const auto& list : {bearings_outside(model), centres_outside(model), jamming_corners(model)})
      warnings.insert(warnings.end(), list.begin(), list.end());
    return warnings;
  }
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; block->kind().contacts && e < block->size(); ++e) {
      const ElementInfo& info = block->info(e);
      // The right side of a gap is its first node.
      if (info.first == ground || info.second == ground) continue;
      const Body &right = model.body(info.first), &left = model.body(info.second);
      if (left.x <= right.x) continue;
      warnings.push_back("Gap \"" + info.name + "\": its left side \"" + left.name + "\" has x = " + to_text(left.x) +
                         " m and its right side \"" + right.name + "\" x = " + to_text(right.x) +
                         " m. Exchange .left and .right, or correct the positions.");
    }
  return warnings;
}

std::vector<std::string> period_warnings(const Model& model) {
  constexpr double longest = 10.0, shortest = 0.02;  // s
  std::vector<std::string> warnings;
  const SparseMatrix stiffness = model.linear_stiffness(StiffnessStage::initial);
  SparseMatrix masses = model.zero_matrix();
  model.mass_matrix().add_to(1.0, masses);
  const std::vector<Building>& buildings = model.buildings();
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    std::set<int> indices;
    for (const NodeId floor : buildings[b].floors)
      for (const NodeId node : model.body_of(floor)) indices.insert(node.index);
    for (const NodeId node : model.body_of(buildings[b].base)) indices.erase(node.index);
    if (indices.empty()) continue;
    const double period = first_period(stiffness, masses, {indices.begin(), indices.end()});
    if (!std::isfinite(period) || (period <= longest && period >= shortest)) continue;
    warnings.push_back("The first period of " + (buildings[b].name.empty() ? "the building" : buildings[b].name) +
                       " held at its base is " + to_text(period) + " s; buildings have " + to_text(shortest) + " to " +
                       to_text(longest) + " s. Check the units of stiffnesses and masses.");
  }
  return warnings;
}

}  // namespace moat
