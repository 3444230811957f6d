#include "analyses/time_history/weight_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "base/text/rows.hpp"

namespace moat {
namespace {

// A warning of rubber whose critical load fell, with its displacement, below a weight that is constant.
void warn_of_unstable_rubber(const AnalysisState& state, std::vector<std::string>& list) {
  const auto& blocks = state.model().blocks();
  std::string first;
  int count = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t e = 0; e < blocks[b]->size(); ++e) {
      const auto quantities = blocks[b]->quantities(e);
      const auto critical = std::ranges::find(quantities, "critical_load", &ReportedQuantity::name);
      if (critical == quantities.end()) continue;
      const double weight = parameter_of(blocks[b]->law(e).parameters, "weight");
      const double load =
          state.elements(b).law_quantity(e, static_cast<std::size_t>(critical - quantities.begin())).value;
      if (weight <= load) continue;
      if (count++ == 0)
        first = "\"" + blocks[b]->info(e).name + "\" became unstable: its weight of " + to_text(weight) +
                " N exceeds the critical load of the displaced rubber, " + to_text(load) + " N.";
    }
  if (count > 1) first += " So did " + counted(count - 1, "other") + ".";
  if (!first.empty()) list.push_back(std::move(first));
}

// The base at height h feels a change dF of a bearing's force as an acceleration, whose moment h dF changes axial
// forces by at most h dF/L, where L is the distance of the bearings. With dF = (F/N) dN the change feeds itself above N
// L/h.
void warn_of_lost_balance(const AnalysisState& state, const WeightOnBearings& weight, std::vector<std::string>& list) {
  double distance = 0.0;
  for (const WeightOnBearings::Bearing& one : weight.bearings())
    for (const WeightOnBearings::Bearing& other : weight.bearings())
      distance = std::max(distance, length(one.on_slab.at - other.on_slab.at));
  const double height = weight.options().base_height.si();
  double largest = 0.0;  // force over axial force
  int count = 0;
  std::string worst;
  for (const WeightOnBearings::Bearing& bearing : weight.bearings()) {
    const auto [block, element] = bearing.element;
    const double force = std::abs(state.elements(block).results()[element].force);
    if (bearing.compression <= 0.0 || force * height <= bearing.compression * distance) continue;
    ++count;
    if (force / bearing.compression <= largest) continue;
    largest = force / bearing.compression;
    worst = state.model().blocks()[block]->info(element).name;
  }
  if (count == 0) return;
  list.push_back("\"" + worst + "\" resists with " + to_text(largest) + " times its axial force" +
                 (count > 1 ? ", " + counted(count - 1, "other") + " with less than that" : "") +
                 ", and there may be no balance of forces any more: as the force falls, the base lifts the bearing "
                 "further. So does a bearing that is pressed against its stop, beyond its capacity. Take bearings with "
                 "more capacity, or results up to this time.");
}

}  // namespace

std::vector<std::string> weight_warnings(const AnalysisState& state, bool ended_early) {
  std::vector<std::string> list;
  warn_of_unstable_rubber(state, list);
  for (const WeightOnBearings& weight : state.weights()) {
    const std::string building = weight.building().empty() ? "The building" : "\"" + weight.building() + "\"";
    if (weight.rocking_time() > 0.0)
      list.push_back(building + " rocked for " + to_text(weight.rocking_time()) +
                     " s, first at t = " + to_text(weight.first_rocking()) +
                     " s: the moment that its bearings cannot balance was dropped. Do not trust later peaks.");
    if (ended_early) warn_of_lost_balance(state, weight, list);
    int lifted = 0;  // of rubber
    for (const WeightOnBearings::Bearing& bearing : weight.bearings())
      if (!bearing.on_slab.slides && bearing.uplifts > 0) lifted += bearing.on_slab.count;
    if (lifted > 0 && weight.options().may_pull.si() == 0.0)
      list.push_back(building + " lifted from " + std::to_string(lifted) +
                     " of its bearings that do not slide. They kept their horizontal force. Give .may_pull where "
                     "bearings are bolted; others lose that force in the air.");
    const auto& first = *std::ranges::min_element(weight.bearings(), {}, &WeightOnBearings::Bearing::first_unstable);
    if (first.instabilities > 0)
      list.push_back(
          "\"" + state.model().blocks()[first.element.block]->info(first.element.element).name +
          "\" is unstable for the first time at t = " + to_text(first.first_unstable) +
          " s: its axial force exceeds the critical load of the displaced rubber. Peaks of bearing_unstable list all "
          "such bearings.");
  }
  return list;
}

}  // namespace moat
