// Checks of every element between two nodes when it is added.
#pragma once

#include <string>
#include <string_view>

#include "base/check.hpp"
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

}  // namespace moat
