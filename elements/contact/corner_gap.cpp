#include "elements/contact/corner_gap.hpp"

#include <cmath>
#include <limits>

namespace moat {

CornerGeometry check_corner(const Model& model, const CornerPlace& gap) {
  const Check check{"CornerGap", gap.name};
  check_point(model, "CornerGap", gap.name, "edge_begin", {gap.edge_of, gap.edge_begin});
  check_point(model, "CornerGap", gap.name, "edge_end", {gap.edge_of, gap.edge_end});
  const PlanVector begin = gap.edge_begin.si(), end = gap.edge_end.si(), at = gap.corner.at.si();
  const PlanVector tangent = unit_direction(check, "edge_end - edge_begin", end - begin);
  CornerGeometry geometry{.normal = -turned_left(tangent)};
  geometry.clearance = dot(begin - at, geometry.normal);
  const PlanVector faced = at + geometry.clearance * geometry.normal;
  const PlanPoint on_edge{gap.edge_of, {Length{faced.x}, Length{faced.y}}};
  check_points(model, "CornerGap", gap.name, "corner", gap.corner, "edge_of", on_edge);
  // Coordinates that are equal but for round-off are wall to wall.
  if (std::abs(geometry.clearance) < same_place) geometry.clearance = 0.0;
  check.not_negative(
      "clearance", geometry.clearance, "m",
      "Overlap at rest: the corner must be on the left of the way from edge_begin to edge_end, or on it.");
  CornerAndEdge& motion = geometry.motion;
  motion.ends = PlanEnds{model, on_edge, gap.corner, geometry.normal};
  motion.edge_begin = dot(begin - at, tangent);
  motion.edge_end = dot(end - at, tangent);
  const MassMatrix& mass = model.mass_matrix();
  const double along = motion.ends.along().mobility(mass), across = motion.ends.across().mobility(mass);
  check.that(along > 0.0, "neither body moves along the normal, so that the gap never changes.",
             "Give bodies that move towards each other.");
  motion.normal_mass = 1.0 / along;
  motion.tangential_mass = across > 0.0 ? 1.0 / across : std::numeric_limits<double>::infinity();
  geometry.cross_mobility = motion.ends.cross_mobility(mass);
  const CornerFriction& friction = gap.friction;
  check.between("friction", friction.coefficient, 0.0, 1.0, "1",
                "Concrete on concrete has 0.4 to 0.6, steel 0.2 to 0.3.");
  motion.friction.coefficient = friction.coefficient;
  if (const auto& stiffness = friction.tangential_stiffness; stiffness && stiffness->ratio != 0.0) {
    check.above_up_to(
        "tangential_stiffness", stiffness->ratio, 0.0, 1.0, "1",
        "A number is the ratio to the tangent of the normal law, 0.85 for example; a constant has a unit, "
        "N/m.");
    motion.friction.tangential_ratio = stiffness->ratio;
  } else if (stiffness) {
    check.positive("tangential_stiffness", stiffness->constant,
                   "Give the stiffness before sliding, or leave it out for 0.85 times that of the normal law.");
    motion.friction.tangential_stiffness = stiffness->constant.si();
  }
  check.above_up_to("share", gap.share, 0.0, 1.0, "1");
  check.not_negative("effective_mass", gap.effective_mass);
  return geometry;
}

std::optional<LawAsGiven> with_friction(std::optional<LawAsGiven> law, const ContactFriction& friction, double share) {
  if (!law || law->parameters.empty()) return std::nullopt;
  law->parameters.push_back({"friction", friction.coefficient, "1"});
  law->parameters.push_back(friction.tangential_ratio > 0.0
                                ? Parameter{"tangential_stiffness_ratio", friction.tangential_ratio, "1"}
                                : Parameter{"tangential_stiffness", friction.tangential_stiffness, "N/m"});
  if (share != 1.0) law->parameters.push_back({"share", share, "1"});
  return law;
}

ElementInfo register_corner(Model& model, const CornerPlace& gap, const CornerGeometry& geometry,
                            std::optional<LawAsGiven> law, ChangeableContact contact) {
  model.register_element("CornerGap", gap.name);
  const CornerAndEdge& motion = geometry.motion;
  ElementDetails details{
      .law_as_given = std::move(law),
      .corner_pair = CornerPair{.corner = gap.corner_name,
                                .edge = gap.edge_name,
                                .position = gap.corner.at.si(),
                                .edge_begin = gap.edge_begin.si(),
                                .edge_end = gap.edge_end.si(),
                                .normal = geometry.normal,
                                .distance_at_rest = motion.distance({geometry.clearance, 0.0}, 0.0, 0.0).value,
                                .may_jam = 1.0 <= motion.normal_mass * motion.friction.coefficient *
                                                      std::abs(geometry.cross_mobility)},
      .changeable_contact = std::move(contact)};
  if (const PlanPoint& corner = gap.corner; !corner.is_on_body()) {
    const auto height = [&](NodeId body) { return body == ground ? 0.0 : model.body(body).height; };
    details.member_ends = MemberEnds{gap.edge_of, MemberPoint{corner.of, corner.other, corner.share},
                                     (1.0 - corner.share) * height(corner.of) + corner.share * height(corner.other)};
  }
  return {.name = gap.name,
          .place = gap.place,
          .first = gap.edge_of,
          .second = gap.corner.of,
          .deformation_quantity = "indentation",
          .force_quantity = "impact_force",
          .offset = geometry.clearance,
          .details = std::make_shared<const ElementDetails>(std::move(details))};
}

template void add_corner(Model&, ElementInfo, const Repeated<AnyContact>&, const CornerAndEdge&);

}  // namespace moat
