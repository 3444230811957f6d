#include "elements/gap.hpp"

namespace moat {
namespace {

// 1/m of a point: how far it moves under a unit impulse.
double mobility(const Model& model, const MemberPoint& point) {
  const auto share = [&](NodeId node, double weight) {
    return node == ground || weight == 0.0 ? 0.0 : weight * weight / model.node(node).mass.si();
  };
  return share(point.node, 1.0 - point.share) + share(point.other, point.share);
}

}  // namespace

void check_member_point(const Model& model, const Check& check, const std::string& name, std::string_view field,
                        const MemberPoint& point) {
  const std::string share = std::string{field} + ".share";
  check.that(point.share >= 0.0 && point.share < 1.0, share, point.share, "1", ">= 0 and < 1",
             "It is the way from the first node to the second; take the second node itself for 1.");
  if (!point.is_node())
    check_link(model, "Gap", name, {std::string{field} + ".node", point.node}, {std::string{field} + ".other", point.other});
}

double effective_mass(const Model& model, const Check& check, const MemberPoint& first, const MemberPoint& second) {
  const double sum = mobility(model, first) + mobility(model, second);
  check.that(sum > 0.0, "neither side has mass.", "At least one side must be a node that can move.");
  return 1.0 / sum;
}

}  // namespace moat
