#include "elements/block/link_checks.hpp"

namespace moat {

Check check_link(const Model& model, std::string_view kind, const std::string& name, NamedEnd first, NamedEnd second) {
  const Check check{kind, name};
  for (const NamedEnd& end : {first, second}) {
    model.require_node(end.node, check, end.field);
    if (const PlacedDiaphragm* diaphragm = model.diaphragm_of(end.node))
      check.that(false,
                 std::string{end.field} + " is the diaphragm \"" + diaphragm->name +
                     "\", and this element has no direction in plan.",
                 "Use a PlanSpring with the same law, two points and a direction.");
  }
  for (const NodeId node : {first.node, second.node})
    check.that(!node.is_follower() || kind == "Gap",
               "\"" + std::string{model.node_name(node)} + "\" follows others, and this element joins nodes alone.",
               "Join the base instead; floors that are given by modes take gaps only.");
  if (first.node == second.node)
    check.that(false,
               std::string{first.field} + " and " + std::string{second.field} + " are the same node, \"" +
                   std::string{model.node_name(first.node)} + "\".",
               "An element joins two different nodes.");
  return check;
}

}  // namespace moat
