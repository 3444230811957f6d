#include "output/files/model_facts.hpp"

#include <algorithm>
#include <utility>

#include "model/building.hpp"
#include "model/model.hpp"

namespace moat {
namespace {

std::string kind_of(const ElementBlock& block, const ElementInfo& info) {
  if (info.isolates) return "bearing";
  if (block.kind().contacts) return "gap";
  return info.drawn_as == DrawnAs::storey ? "storey" : "other";
}

ElementFacts facts_of(const Model& model, const ElementBlock& block, std::size_t element) {
  const ElementInfo& info = block.info(element);
  LawAsGiven law = block.law(element);
  ElementFacts facts{.name = info.name,
                     .kind = kind_of(block, info),
                     .law = std::move(law.name),
                     .first = std::string{model.body_name(info.first)},
                     .second = std::string{model.body_name(info.second)},
                     .parameters = {}};
  facts.place = info.listed_under();
  if (const BearingOnSlab* bearing = info.detail(&ElementDetails::bearing_on_slab))
    facts.static_weight = bearing->static_weight;
  if (const PlanPlaces* places = info.plan_places()) facts.plan_places = *places;
  if (const MemberEnds* ends = info.member_ends()) {
    const auto& [first, second, height] = *ends;
    if (!first.is_node()) facts.first_other = model.body_name(first.other);
    if (!second.is_node()) facts.second_other = model.body_name(second.other);
    facts.first_share = first.share;
    facts.second_share = second.share;
  }
  if (block.kind().contacts) facts.parameters.push_back({"clearance", info.offset, "m"});
  for (const Parameter& each : law.parameters)
    facts.parameters.push_back({std::string{each.name}, each.value, std::string{each.unit}});
  return facts;
}

void add_plan(const Model& model, ModelFacts& facts) {
  std::vector<NodeId> bases;
  for (const Building& building : all_buildings(model)) {
    bases.push_back(building.base);
    bases.insert(bases.end(), building.slabs.begin(), building.slabs.end());
  }
  for (const PlacedDiaphragm& each : model.diaphragms()) {
    DiaphragmFacts diaphragm{.name = each.name,
                             .gyration = each.gyration,
                             .centre_of_mass = each.centre_of_mass,
                             .is_base = std::ranges::find(bases, each.id.x) != bases.end()};
    for (std::size_t i = 0; i < each.outline.size(); ++i) diaphragm.outline.push_back(each.outline.corner(i));
    facts.diaphragms.push_back(std::move(diaphragm));
  }
  for (const auto& block : model.blocks()) {
    for (std::size_t e = 0; e < block->size(); ++e) {
      const ElementInfo& info = block->info(e);
      if (info.corner_pair() == nullptr) continue;
      facts.corners.push_back({*info.corner_pair(), info.name, std::string{model.body_name(info.second)}, info.offset,
                               model.diaphragm_of(info.first) == nullptr});
    }
  }
}

}  // namespace

ModelFacts facts_of(const Model& model) {
  ModelFacts facts;
  const MotionState initial = model.initial_motion();
  for (int i = 0; i < model.nodes(); ++i) {
    const NodeId node = model.node(i);
    const Body& body = model.body(node);
    const auto at_start = [&](const Vector& values) { return i < model.degrees_of_freedom() ? values[i] : 0.0; };
    facts.nodes.push_back({std::string{model.node_name(node)}, model.mass(node), body.x, body.height,
                           at_start(initial.displacement), at_start(initial.velocity)});
  }
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e) facts.elements.push_back(facts_of(model, *block, e));
  if (model.is_plan()) add_plan(model, facts);
  return facts;
}

}  // namespace moat
