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
  if (friction.tangential_stiffness)
    check.positive("tangential_stiffness", *friction.tangential_stiffness,
                   "Give the stiffness before sliding, or leave it out for 0.85 times that of the normal law.");
  motion.friction = {friction.coefficient, friction.tangential_stiffness.value_or(Stiffness{}).si()};
  check.above_up_to("share", gap.share, 0.0, 1.0, "1");
  check.not_negative("effective_mass", gap.effective_mass);
  return geometry;
}

ElementInfo register_corner(Model& model, const CornerPlace& gap, const CornerGeometry& geometry, std::string_view law,
                            std::vector<Parameter> parameters) {
  model.register_element("CornerGap", gap.name);
  const CornerAndEdge& motion = geometry.motion;
  ElementDetails details{.corner_pair =
                             CornerPair{.corner = gap.corner_name,
                                        .edge = gap.edge_name,
                                        .position = gap.corner.at.si(),
                                        .edge_begin = gap.edge_begin.si(),
                                        .edge_end = gap.edge_end.si(),
                                        .normal = geometry.normal,
                                        .distance_at_rest = motion.distance({geometry.clearance, 0.0}, 0.0, 0.0).value,
                                        .may_jam = 1.0 <= motion.normal_mass * motion.friction.coefficient *
                                                              std::abs(geometry.cross_mobility)}};
  if (const PlanPoint& corner = gap.corner; !corner.is_on_body()) {
    const auto height = [&](NodeId body) { return body == ground ? 0.0 : model.body(body).height; };
    details.member_ends = MemberEnds{gap.edge_of, MemberPoint{corner.of, corner.other, corner.share},
                                     (1.0 - corner.share) * height(corner.of) + corner.share * height(corner.other)};
  }
  if (!parameters.empty()) {
    parameters.push_back({"friction", motion.friction.coefficient, "1"});
    parameters.push_back({"tangential_stiffness", motion.friction.tangential_stiffness, "N/m"});
    if (gap.share != 1.0) parameters.push_back({"share", gap.share, "1"});
    details.law_as_given = LawAsGiven{std::string{law}, std::move(parameters)};
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
