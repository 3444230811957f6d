#include "elements/link_checks.hpp"

namespace moat {

Check check_link(const Model& model, std::string_view kind, const std::string& name, NamedEnd first, NamedEnd second) {
  const std::string object = std::string{kind} + " \"" + name + "\"";
  model.require_node(first.node, object, first.field);
  model.require_node(second.node, object, second.field);
  Check check{kind, name};
  check.that(first.node != second.node,
             std::string{first.field} + " and " + std::string{second.field} + " are the same node, \"" +
                 std::string{model.node_name(first.node)} + "\".",
             "An element joins two different nodes.");
  return check;
}

}  // namespace moat
