#include "analyses/case/case_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "analyses/events/guards.hpp"
#include "base/check.hpp"
#include "base/units.hpp"
#include "model/building.hpp"
#include "motions/readers/read_motion.hpp"
#include "output/files/engineering_unit.hpp"
#include "solvers/modes.hpp"

namespace moat {
namespace {

// Advice that makes this kind of steps finer.
std::string finer(const TransientOptions& options) {
  if (options.step.si() > 0.0) return "Take a shorter step (now " + to_text(options.step.si()) + " s)";
  if (is_exact(options.integrator))
    return "Raise TransientOptions::steps_per_contact (now " + std::to_string(options.steps_per_contact) +
           "), shorten largest_step, or compare with Newmark";
  if (options.tolerance <= TransientOptions::least_tolerance)
    return "No tolerance is tighter: look for stiff elements at small masses and for wrong units";
  return "Take a tighter tolerance (now " + to_text(options.tolerance) + ")";
}

bool all_finite(const EnergyBalance& energy) {
  return std::ranges::all_of(
      std::initializer_list<double>{energy.input, energy.kinetic, energy.strain, energy.viscous, energy.hysteretic,
                                    energy.impact, energy.friction, energy.equation_residual, energy.integration_error,
                                    energy.largest_input, energy.largest_kinetic},
      [](double value) { return std::isfinite(value); });
}

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

double parameter_of(const LawAsGiven& law, std::string_view name, double otherwise = 0.0) {
  const auto found = std::ranges::find(law.parameters, name, &Parameter::name);
  return found == law.parameters.end() ? otherwise : found->value;
}

// N: the force at zero deformation after yielding, as the parameters of a law give it; 0 for a law without one.
double strength_of(const LawAsGiven& law) {
  const double of_yield = parameter_of(law, "yield_force") -
                          parameter_of(law, "post_yield_stiffness") * parameter_of(law, "yield_displacement");
  return parameter_of(law, "strength", parameter_of(law, "characteristic_strength", of_yield));
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
      const double count = parameter_of(law, "count", 1.0);
      strength += count * strength_of(law);
      designed += count * parameter_of(given, "weight", unknown);
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
    // The columns of the degrees of freedom that move while base and others are held.
    std::vector<Eigen::Triplet<double>> moving;
    for (const int index : indices) moving.emplace_back(index, static_cast<int>(moving.size()), 1.0);
    SparseMatrix columns{stiffness.rows(), static_cast<Eigen::Index>(moving.size())};
    columns.setFromTriplets(moving.begin(), moving.end());
    const SparseMatrix held = columns.transpose() * stiffness * columns, mass = columns.transpose() * masses * columns;
    const double period = slowest_modes(held, mass, 1).front().period();
    if (!std::isfinite(period) || (period <= longest && period >= shortest)) continue;
    warnings.push_back("The first period of " + (buildings[b].name.empty() ? "the building" : buildings[b].name) +
                       " held at its base is " + to_text(period) + " s; buildings have " + to_text(shortest) + " to " +
                       to_text(longest) + " s. Check the units of stiffnesses and masses.");
  }
  return warnings;
}

std::vector<std::string> plan_warnings(const AnalysisState& state, const std::vector<Peak>& peaks,
                                       const std::vector<Impact>& impacts) {
  std::vector<std::string> warnings;
  const Model& model = state.model();
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    for (std::size_t e = 0; e < model.blocks()[b]->size(); ++e) {
      const int times = state.elements(b).contact(e).departures;
      if (times == 0) continue;
      warnings.push_back(
          "\"" + model.blocks()[b]->info(e).name + "\": the corner left its edge in contact, " + std::to_string(times) +
          (times == 1 ? " time" : " times") +
          ". It slid past an end and was released; the energy it had stored counts as lost in the impact. "
          "Check the outline of the wall there.");
    }
  }
  double largest_indentation = 0.0;
  for (const Impact& impact : impacts) largest_indentation = std::max(largest_indentation, impact.largest_indentation);
  std::string worst;
  double most_neglected = 0.0;
  int turned = 0;
  for (const PlacedDiaphragm& diaphragm : model.diaphragms()) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < diaphragm.outline.size(); ++i)
      farthest = std::max(farthest, length(diaphragm.outline.corner(i) - diaphragm.centre_of_mass));
    const auto rotation = std::ranges::find_if(
        peaks, [&](const Peak& peak) { return peak.quantity == "rotation" && peak.where == diaphragm.name; });
    if (rotation == peaks.end()) continue;
    constexpr double noticeable = 1e-3, share_of_indentation = 0.1;  // m, 1
    const double neglected = 0.5 * farthest * rotation->value * rotation->value;
    if (neglected <= noticeable &&
        (largest_indentation == 0.0 || neglected <= share_of_indentation * largest_indentation))
      continue;
    ++turned;
    if (neglected <= most_neglected) continue;
    most_neglected = neglected;
    worst = "The rotation of \"" + diaphragm.name + "\" reached " + to_text(rotation->magnitude()) +
            " rad. Displacements are linear in it; at its corners they neglect " + to_text(1e3 * neglected) + " mm";
  }
  if (turned > 0)
    warnings.push_back(worst + (turned > 1 ? ", the most of " + std::to_string(turned) + " floors" : "") +
                       ". Where indentations are as small, compare with a smaller motion.");
  return warnings;
}

std::vector<std::string> strain_warnings(const std::vector<Peak>& peaks) {
  std::vector<std::string> warnings;
  for (const Peak& peak : peaks)
    if (peak.quantity == "fitted_strain_share" && peak.value > 1.0)
      warnings.push_back("The strain of \"" + peak.where + "\" reached " + to_text(peak.value) +
                         " times the largest for which its parameters were fitted. Take a bearing with more rubber, or "
                         "parameters from tests to this strain.");
  return warnings;
}

std::vector<std::string> collapse_warnings(const std::vector<Peak>& peaks) {
  constexpr double no_building_stands = 3.0;  // m
  Peak largest;
  for (const Peak& peak : peaks)
    if ((peak.quantity == "drift" || peak.quantity == "isolator_deformation") && peak.magnitude() > largest.magnitude())
      largest = peak;
  if (largest.magnitude() <= no_building_stands || largest.magnitude() > CollapseGuard::largest_deformation) return {};
  return {"The model collapsed: the " + in_words(largest.quantity) + " of \"" + largest.where + "\" reached " +
          to_text(largest.magnitude()) + " m, and no building stands " + to_text(no_building_stands) +
          " m. Check p_delta, softening laws and units."};
}

std::vector<std::string> energy_warnings(const EnergyBalance& energy, double bound, const TransientOptions& options) {
  if (!all_finite(energy))
    return {
        "An energy is not a finite number, so that the balance says nothing of the results. Look for a motion, a mass "
        "or a stiffness of a wrong unit; peaks may be wrong."};
  std::vector<std::string> warnings;
  if (energy.share(energy.integration_error) > bound)
    warnings.push_back(
        "The energy of the elements is off by " + to_text(100.0 * energy.share(energy.integration_error)) +
        " % of the largest input or kinetic energy, most at \"" + energy.worst_element + "\". " + finer(options) + ".");
  if (energy.share(energy.equation_residual) > bound)
    warnings.push_back("The equations do not balance: work and kinetic energy are off by " +
                       to_text(100.0 * energy.share(energy.equation_residual)) +
                       " % of the largest input or kinetic energy. " + finer(options) +
                       "; if that does not help, a tighter TransientOptions::force_tolerance (now " +
                       to_text(options.force_tolerance) + ").");
  return warnings;
}

std::string unsettled_warning(const ErrorBars& bars, std::size_t impacts, const TransientOptions& options) {
  const bool pounds = impacts > 0 || bars.companion_impacts > 0;
  return "The case is not settled: " + bars.reason + ". " + finer(options) +
         (pounds ? ". Impacts amplify every small difference: where finer steps do not help, the numbers are known to "
                   "their error bars only."
                 : ".");
}

}  // namespace moat
