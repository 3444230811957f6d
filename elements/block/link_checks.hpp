// Adds a law between two nodes, with the checks that every such element needs.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "elements/block/link_block.hpp"
#include "model/model.hpp"

namespace moat {

/// An end of an element, and the field that names it in messages.
struct NamedEnd {
  std::string_view field;  ///< "lower"
  NodeId node;             ///< the node given there
};

/// Throws InputError unless both ends are nodes of the model (or the ground) and differ; returns the
/// Check that names the element.
Check check_link(const Model& model, std::string_view kind, const std::string& name, NamedEnd first, NamedEnd second);

/// Adds an element whose ends are the fields `lower` and `upper`. Throws InputError for unknown or equal nodes, a name
/// that is taken, or a parameter that the law refuses.
template <ForceLaw Law>
void add_link(Model& model, std::string_view kind, ElementInfo info, const Law& law) {
  const Check check = check_link(model, kind, info.name, {"lower", info.first}, {"upper", info.second});
  if constexpr (requires { law.check(check); }) law.check(check);
  model.register_element(kind, info.name);
  model.block<LinkBlock<Law>>().add(std::move(info), law);
}

}  // namespace moat
