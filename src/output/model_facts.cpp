#include "output/model_facts.hpp"

#include "model/model.hpp"
#include "output/gaps_of.hpp"

namespace moat {
namespace {

ElementFacts facts_of(const Model& model, const ElementBlock& block, std::size_t element) {
  const ElementInfo& info = block.info(element);
  const LawAsGiven* given = info.law_as_given.get();
  ElementFacts facts{.name = info.name,
                     .law = given != nullptr ? given->name : block.law_name(element),
                     .first = std::string{model.node_name(info.first)},
                     .second = std::string{model.node_name(info.second)},
                     .parameters = {}};
  if (has_gaps(block)) facts.parameters.push_back({"clearance", info.offset, "m"});
  for (const Parameter& each : given != nullptr ? given->parameters : block.parameters(element))
    facts.parameters.push_back({std::string{each.name}, each.value, std::string{each.unit}});
  return facts;
}

}  // namespace

ModelFacts facts_of(const Model& model) {
  ModelFacts facts;
  for (const Node& node : model.nodes())
    facts.nodes.push_back({node.name, node.mass.value().si(), node.x.si(), node.height.si()});
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e) facts.elements.push_back(facts_of(model, *block, e));
  return facts;
}

}  // namespace moat
