#include "analyses/case/contact_sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "base/text/number_format.hpp"
#include "model/with_contacts.hpp"

namespace moat {
namespace {

// Contact stiffnesses of one situation differ by a factor of ten between sources: from a third to three times their
// geometric mean. Passive pressures of design practice and of tests differ by 1.6.
constexpr double stiffness_range = 3.0, restitution_step = 0.1, clearance_step = 0.1, soil_range = 1.6;

std::vector<ContactVariation> changes_of(const ChangeableParameters& can) {
  std::vector<ContactVariation> list;
  if (can.stiffness)
    for (const double factor : {1.0 / stiffness_range, stiffness_range})
      list.push_back({.parameter = "stiffness", .factor = factor});
  if (can.restitution)
    for (const double difference : {-restitution_step, restitution_step})
      list.push_back({.parameter = "restitution", .difference = difference});
  if (can.clearance)
    for (const double factor : {1.0 - clearance_step, 1.0 + clearance_step})
      list.push_back({.parameter = "clearance", .factor = factor});
  if (can.soil)
    for (const double factor : {1.0 / soil_range, soil_range}) list.push_back({.parameter = "soil", .factor = factor});
  return list;
}

ContactChange change_of(const ContactVariation& variation) {
  ContactChange change{.restitution_change = variation.difference};
  if (variation.parameter == "stiffness") change.stiffness_factor = variation.factor;
  if (variation.parameter == "clearance") change.clearance_factor = variation.factor;
  if (variation.parameter == "soil") change.soil_factor = variation.factor;
  return change;
}

// Calls a function for every gap, in the order of the elements, which is that of the clearances.
template <class Function>
void for_each_gap(const Model& model, Function function) {
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; block->kind().contacts && e < block->size(); ++e) function(block->info(e));
}

// The largest share of its clearance by which a gap came nearer to closing; 1 where bodies are wall to wall. In plan
// the distance of a corner is at most that along the normal whenever it faces its edge.
double nearest_approach(const Model& model, const std::vector<GapClearance>& clearances) {
  double nearest = 0.0;
  auto gap = clearances.begin();
  for_each_gap(model, [&](const ElementInfo& info) {
    if (gap == clearances.end()) return;
    nearest = std::max(nearest, info.offset > 0.0 ? 1.0 - gap->left / info.offset : 1.0);
    ++gap;
  });
  return nearest;
}

std::map<std::string, std::size_t> impacts_by_place(const std::map<std::string, std::string>& place_of_gap,
                                                    const std::vector<Impact>& impacts) {
  std::map<std::string, std::size_t> count;
  for (const Impact& impact : impacts) ++count[place_of_gap.at(impact.where)];
  return count;
}

std::vector<std::pair<std::string, std::string>> contact_of(const Model& model, const std::vector<Impact>& nominal,
                                                            const std::vector<Impact>& changed) {
  std::map<std::string, std::string> place_of_gap;
  for_each_gap(model, [&](const ElementInfo& info) { place_of_gap[info.name] = info.listed_under(); });
  auto before = impacts_by_place(place_of_gap, nominal), after = impacts_by_place(place_of_gap, changed);
  for (const auto& [place, count] : after) before.try_emplace(place, 0);
  std::vector<std::pair<std::string, std::string>> contact;
  for (const auto& [place, count] : before) {
    const std::size_t now = after[place];
    contact.emplace_back(place, count == now  ? "same"
                                : count == 0  ? "appears"
                                : now == 0    ? "vanishes"
                                : now < count ? "fewer"
                                              : "more");
  }
  return contact;
}

void run_changed(ContactVariation& variation, ContactSensitivity& result, const Model& model,
                 const GroundMotion& motion, const TransientOptions& options, const PeaksAndImpacts& main,
                 StepObserver* observer, const std::function<bool()>& stop, RunUnderWay& under_way) {
  std::vector<Peak> peaks;
  try {
    const Model changed = with_contacts(model, change_of(variation));
    if (variation.parameter == "restitution") variation.restitutions = restitutions_of_contacts(changed);
    PeaksAndImpacts run = compute_peaks(changed, motion, options, {observer}, stop, &under_way);
    if (run.collapsed)
      variation.failure = "the model collapsed.";
    else
      peaks = std::move(run.peaks);
    variation.impacts = run.touches.size();
    variation.contact = contact_of(model, main.touches, run.touches);
  } catch (const Error& error) {
    variation.failure = error.what();
  }
  // Two runs of one model list the same peaks in the same order.
  for (std::size_t i = 0; i < result.peaks.size(); ++i) {
    ChangedPeak& peak = result.peaks[i];
    const bool found = i < peaks.size() && peaks[i].quantity == peak.quantity && peaks[i].where == peak.where;
    peak.changed.push_back(found ? peaks[i].value : std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace

bool contact_sensitivity_is_cheap(const Model& model, double solves, std::size_t runs) {
  constexpr double most_evaluations = 2e6;
  double elements = 0.0;
  for (const auto& block : model.blocks()) elements += static_cast<double>(block->size());
  return static_cast<double>(runs) * solves * elements <= most_evaluations;
}

ContactSensitivity contact_sensitivity(const Model& model, const GroundMotion& motion, const TransientOptions& options,
                                       ContactSensitivityMode mode, const PeaksAndImpacts& main, StepObserver* observer,
                                       const std::function<bool()>& stop, ContactRuns* runs) {
  ContactSensitivity result{.impacts = main.touches.size()};
  if (main.clearances.empty()) return result;
  const auto without_runs = [&](const std::string& reason) {
    result.reason = reason;
    return result;
  };
  if (mode == ContactSensitivityMode::never) return without_runs("It was not wanted.");
  if (main.collapsed) return without_runs("The model collapsed, and peaks of a fall depend on where it is stopped.");
  const ChangeableParameters can = changeable_parameters(model);
  result.unchanged_laws = can.unchanged_laws;
  for_each_gap(model,
               [&](const ElementInfo& gap) { result.rigid_walls |= gap.first == ground || gap.second == ground; });
  result.changes = changes_of(can);
  if (main.touches.empty()) {
    const double nearest = nearest_approach(model, main.clearances);
    result.computed = nearest < 1.0 - clearance_step;
    std::erase_if(result.changes, [&](const ContactVariation& each) {
      return result.computed || each.parameter != "clearance" || each.factor > 1.0;
    });
    if (result.computed)
      return without_runs("No contact, also with other stiffness and restitution, until the clearance is " +
                          to_fixed(std::floor(100.0 * (1.0 - nearest)), 0) + " % smaller.");
  }
  if (result.changes.empty()) return without_runs("The contacts have no parameter that can be changed.");
  const auto solves = static_cast<double>(std::max(main.solver.newton_iterations, main.solver.accepted_steps));
  if (mode == ContactSensitivityMode::automatic &&
      !contact_sensitivity_is_cheap(model, solves, result.changes.size())) {
    result.runs_left_out = result.changes.size();
    result.changes.clear();
    return without_runs(
        "Not computed by default for a run of this size (steps times elements): --sensitivity (in code "
        "CaseOptions::contact_sensitivity = ContactSensitivityMode::always).");
  }
  const std::vector<std::string> walls = bodies_beside_buildings(model);
  for (const Peak& peak : main.peaks)
    result.peaks.push_back({.quantity = peak.quantity,
                            .where = peak.where,
                            .unit = peak.unit,
                            .value = peak.value,
                            .of_wall = std::ranges::find(walls, peak.where) != walls.end()});
  ContactRuns new_runs;
  if (runs == nullptr) runs = &new_runs;
  if (runs->count == 0) runs->finished = std::move(result);
  ContactSensitivity& all = runs->finished;
  for (; runs->count < all.changes.size(); ++runs->count)
    run_changed(all.changes[runs->count], all, model, motion, options, main, observer, stop, runs->under_way);
  all.computed = true;
  return all;
}

}  // namespace moat
