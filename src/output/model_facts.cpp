#include "output/model_facts.hpp"

#include "model/model.hpp"
#include "output/gaps_of.hpp"

namespace moat {
namespace {

ElementFacts facts_of(const Model& model, const ElementBlock& block, std::size_t element) {
  const ElementInfo& info = block.info(element);
  ElementFacts facts{.name = info.name,
                     .law = {},
                     .first = std::string{model.node_name(info.first)},
                     .second = std::string{model.node_name(info.second)},
                     .parameters = {}};
  if (is_gap(block, element)) facts.parameters.push_back({"clearance", info.offset, "m"});
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
