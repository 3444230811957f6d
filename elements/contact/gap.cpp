#include "elements/contact/gap.hpp"

#include <algorithm>
#include <cmath>

namespace moat {
namespace {

void check_point(const Model& model, const Check& check, const std::string& name, std::string_view field,
                 const MemberPoint& point) {
  const std::string share = std::string{field} + ".share";
  check.that(point.share >= 0.0 && point.share < 1.0, share, point.share, "1", ">= 0 and < 1",
             "It is the way from the first node to the second; take the second node itself for 1.");
  if (point.is_node())
    model.require_node(point.node, check, field);
  else
    check_link(model, "Gap", name, {std::string{field} + ".node", point.node},
               {std::string{field} + ".other", point.other});
}

Check check_ends(const Model& model, const GapPlace& gap) {
  if (gap.left.is_node() && gap.right.is_node())
    return check_link(model, "Gap", gap.name, {"left", gap.left.node}, {"right", gap.right.node});
  const Check check{"Gap", gap.name};
  check_point(model, check, gap.name, "left", gap.left);
  check_point(model, check, gap.name, "right", gap.right);
  return check;
}

std::optional<MemberEnds> member_ends(const Model& model, const MemberPoint& left, const MemberPoint& right) {
  if (left.is_node() && right.is_node()) return std::nullopt;
  const MemberPoint& drawn = !left.is_node() && right.is_node() && right.node != ground ? right : left;
  const auto height = [&](NodeId node) { return node == ground ? 0.0 : model.body(node).height; };
  return MemberEnds{right, left, (1.0 - drawn.share) * height(drawn.node) + drawn.share * height(drawn.other)};
}

}  // namespace

Check check_gap(const Model& model, const GapPlace& gap) {
  const Check check = check_ends(model, gap);
  check.not_negative("clearance", gap.clearance,
                     "Give the free distance at rest, 0 m for wall to wall; a preload is an initial_displacement.");
  return check;
}

double effective_mass(const Model& model, const Check& check, const MemberPoint& first, const MemberPoint& second) {
  const double mobility = WeightedEnds{model, first, second}.mobility(model.mass_matrix());
  check.that(mobility > 0.0, "left and right are the same point, so that the gap never changes.",
             "Give two points that move towards each other.");
  return 1.0 / mobility;
}

ElementInfo register_gap(Model& model, const GapPlace& gap, std::optional<LawAsGiven> law, ChangeableContact contact) {
  model.register_element("Gap", gap.name);
  return {.name = gap.name,
          .place = gap.place,
          .first = gap.right.node,
          .second = gap.left.node,
          .deformation_quantity = "indentation",
          .force_quantity = "impact_force",
          .offset = gap.clearance.si(),
          .details = std::make_shared<const ElementDetails>(
              ElementDetails{.law_as_given = std::move(law),
                             .member_ends = member_ends(model, gap.left, gap.right),
                             .changeable_contact = std::move(contact)})};
}

ElementInfo changed_gap(ElementInfo gap, const ContactChange& change, std::optional<LawAsGiven> law,
                        ChangeableContact contact) {
  ElementDetails details = *gap.details;
  details.law_as_given = std::move(law);
  details.changeable_contact = std::move(contact);
  const double before = gap.offset;
  gap.offset *= change.clearance_factor;
  if (details.corner_pair && gap.offset != before) {
    CornerPair& pair = *details.corner_pair;
    const PlanVector shift = (gap.offset - before) * pair.normal;
    pair.edge_begin = pair.edge_begin + shift;
    pair.edge_end = pair.edge_end + shift;
    // Along the edge it stays where it is.
    const double beside = std::sqrt(std::max(pair.distance_at_rest * pair.distance_at_rest - before * before, 0.0));
    pair.distance_at_rest = std::hypot(gap.offset, beside);
  }
  gap.details = std::make_shared<const ElementDetails>(std::move(details));
  return gap;
}

template void add_contact(Model&, ElementInfo, const AnyContact&, double, const MemberPoint&, const MemberPoint&);
template void replace_contact(ElementBlock&, std::size_t, ElementInfo, const AnyContact&);

}  // namespace moat
