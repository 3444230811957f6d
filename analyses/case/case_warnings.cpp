#include "analyses/case/case_warnings.hpp"

#include <algorithm>
#include <cmath>

#include "analyses/events/guards.hpp"
#include "base/check.hpp"
#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"

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

}  // namespace

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

std::vector<std::string> wall_warnings(const Model& model, const std::vector<Peak>& peaks) {
  constexpr double most = 10.0;  // No wall of a building stands a larger ductility.
  std::vector<std::string> warnings;
  const auto peak_at = [&](const std::string& quantity, const std::string& where) {
    const auto same = [&](const Peak& peak) { return peak.quantity == quantity && peak.where == where; };
    const auto found = std::ranges::find_if(peaks, same);
    return found == peaks.end() ? 0.0 : found->magnitude();
  };
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e) {
      const ElementInfo& info = block->info(e);
      const bool is_wall = info.deformation_quantity == "wall_deformation",
                 is_soil = info.force_quantity == "backfill_force";
      if (!is_wall && !is_soil) continue;
      const LawAsGiven law = block->law_of_block(e);
      const double ductility =
          peak_at("wall_deformation", info.name) / parameter_of(law.parameters, "yield_displacement", 1e300);
      if (is_wall && ductility > most)
        warnings.push_back("\"" + info.name + "\" was pushed to " + to_significant(ductility, 3) +
                           " times its yield displacement. Its law yields without an end, but no wall does: count on "
                           "the soil behind it alone, or give a law that loses strength, such as ImkBilinear.");
      const double force = peak_at("backfill_force", info.name),
                   capacity = parameter_of(law.parameters, "ultimate_force", 1e300);
      if (is_soil && force > capacity)
        warnings.push_back("\"" + info.name + "\" resists with " + to_significant(force / 1e3, 4) +
                           " kN, more than its ultimate_force of " + to_significant(capacity / 1e3, 4) +
                           " kN: the hyperbola tends to ultimate_force/failure_ratio. Give .failure_ratio = 1 for "
                           "soil that never exceeds it.");
    }
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
