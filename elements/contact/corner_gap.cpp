#include "elements/contact/corner_gap.hpp"

#include <cmath>
#include <limits>

namespace moat {

namespace {

CornerGeometry corner_geometry(const Model& model, const std::string& name, const PlanPoint& corner, NodeId edge_of,
                               PlanPosition edge_begin, PlanPosition edge_end) {
  check_point(model, "CornerGap", name, "edge_begin", {edge_of, edge_begin});
  check_point(model, "CornerGap", name, "edge_end", {edge_of, edge_end});
  const PlanVector begin = edge_begin.si(), end = edge_end.si(), at = corner.at.si();
  CornerGeometry geometry;
  const Check check{"CornerGap", name};
  const PlanVector tangent = unit_direction(check, "edge_end - edge_begin", end - begin);
  geometry.normal = -turned_left(tangent);
  geometry.clearance = dot(begin - at, geometry.normal);
  const PlanVector faced = at + geometry.clearance * geometry.normal;
  const PlanPoint on_edge{edge_of, {Length{faced.x}, Length{faced.y}}};
  check_points(model, "CornerGap", name, "corner", corner, "edge_of", on_edge);
  // Coordinates that are equal but for round-off are wall to wall.
  if (std::abs(geometry.clearance) < same_place) geometry.clearance = 0.0;
  check.not_negative(
      "clearance", geometry.clearance, "m",
      "Overlap at rest: the corner must be on the left of the way from edge_begin to edge_end, or on it.");
  geometry.ends = PlanEnds{model, on_edge, corner, geometry.normal};
  geometry.edge_begin = dot(begin - at, tangent);
  geometry.edge_end = dot(end - at, tangent);
  const MassMatrix& mass = model.mass_matrix();
  const double along = geometry.ends.along().mobility(mass), across = geometry.ends.across().mobility(mass);
  check.that(along > 0.0, "neither body moves along the normal, so that the gap never changes.",
             "Give bodies that move towards each other.");
  geometry.normal_mass = 1.0 / along;
  geometry.cross_mobility = geometry.ends.cross_mobility(mass);
  geometry.tangential_mass = across > 0.0 ? 1.0 / across : std::numeric_limits<double>::infinity();
  return geometry;
}

void check_friction(const Check& check, const CornerFriction& friction) {
  check.between("friction", friction.coefficient, 0.0, 1.0, "1",
                "Concrete on concrete has 0.4 to 0.6, steel 0.2 to 0.3.");
  if (friction.tangential_stiffness)
    check.positive("tangential_stiffness", *friction.tangential_stiffness,
                   "Give the stiffness before sliding, or leave it out for 0.85 times that of the normal law.");
}

}  // namespace

CornerGeometry check_corner(const Model& model, const CornerPlace& gap) {
  const CornerGeometry geometry =
      corner_geometry(model, gap.name, gap.corner, gap.edge_of, gap.edge_begin, gap.edge_end);
  const Check check{"CornerGap", gap.name};
  check_friction(check, gap.friction);
  check.above_up_to("share", gap.share, 0.0, 1.0, "1");
  check.not_negative("effective_mass", gap.effective_mass);
  return geometry;
}

CornerAndEdge corner_and_edge(const CornerPlace& gap, const CornerGeometry& geometry, double tangent) {
  constexpr double of_tangent = 0.85;
  const double tangential_stiffness =
      gap.friction.tangential_stiffness ? gap.friction.tangential_stiffness->si() : of_tangent * tangent;
  return {.ends = geometry.ends,
          .friction = {gap.friction.coefficient, tangential_stiffness},
          .edge_begin = geometry.edge_begin,
          .edge_end = geometry.edge_end,
          .normal_mass = geometry.normal_mass,
          .tangential_mass = geometry.tangential_mass};
}

ElementInfo register_corner(Model& model, const CornerPlace& gap, const CornerGeometry& geometry,
                            const CornerAndEdge& corner, std::string_view law, std::vector<Parameter> parameters) {
  model.register_element("CornerGap", gap.name);
  ElementDetails details{.corner_pair =
                             CornerPair{.corner = gap.corner_name,
                                        .edge = gap.edge_name,
                                        .position = gap.corner.at.si(),
                                        .edge_begin = gap.edge_begin.si(),
                                        .edge_end = gap.edge_end.si(),
                                        .normal = geometry.normal,
                                        .distance_at_rest = corner.distance({geometry.clearance, 0.0}, 0.0, 0.0).value,
                                        .may_jam = 1.0 <= corner.normal_mass * corner.friction.coefficient *
                                                              std::abs(geometry.cross_mobility)}};
  ElementInfo info{.name = gap.name,
                   .place = gap.place,
                   .first = gap.edge_of,
                   .second = gap.corner.of,
                   .deformation_quantity = "indentation",
                   .force_quantity = "impact_force",
                   .offset = geometry.clearance};
  if (!parameters.empty()) {
    parameters.push_back({"friction", corner.friction.coefficient, "1"});
    parameters.push_back({"tangential_stiffness", corner.friction.tangential_stiffness, "N/m"});
    if (gap.share != 1.0) parameters.push_back({"share", gap.share, "1"});
    details.law_as_given = LawAsGiven{std::string{law}, std::move(parameters)};
  }
  info.details = std::make_shared<const ElementDetails>(std::move(details));
  return info;
}

template void add_corner(Model&, ElementInfo, const SharedContact<AnyContact>&, const CornerAndEdge&);
template void add_corner(Model&, ElementInfo, const SharedContact<BilinearContact>&, const CornerAndEdge&);
template void add_corner(Model&, ElementInfo, const SharedContact<RootDampedHertzContact>&, const CornerAndEdge&);
template void add_corner(Model&, ElementInfo, const SharedContact<ViscousHertzContact>&, const CornerAndEdge&);
template void add_corner(Model&, ElementInfo, const SharedContact<ViscousLinearContact>&, const CornerAndEdge&);

}  // namespace moat
