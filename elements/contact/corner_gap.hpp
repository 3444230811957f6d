// A corner that can hit an edge, in plan.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "elements/block/corner_and_edge.hpp"
#include "elements/contact/gap.hpp"
#include "materials/repeated.hpp"

namespace moat {

/// Coulomb friction between a corner and an edge. A number converts to it: `.friction = 0.4`.
struct CornerFriction {
  /// mu, from 0 to 1: concrete on concrete 0.4 to 0.6, steel 0.2 to 0.3. 0 is none.
  double coefficient = 0.0;
  /// k_t > 0 N/m, of the contact before it slides. Left out it is 0.85 times the tangent of the normal law at an
  /// indentation of 10 mm (Mindlin 1949: 2 (1 - nu)/(2 - nu) = 0.89 for nu = 0.2).
  std::optional<Stiffness> tangential_stiffness{};

  /// Coefficient >= 0; stiffness along the wall > 0 N/m, chosen by the law without one.
  CornerFriction(double friction_coefficient = 0.0, std::optional<Stiffness> stiffness = {})
      : coefficient{friction_coefficient}, tangential_stiffness{stiffness} {}
};

/// Contact of a corner with a straight edge of another body, or of the ground.
///
///                   | edge_end
///      +            |                 the corner is on the left of the way from begin to end;
///      |   corner   |                 normal n points from the corner's body to the edge's,
///      +-----+ ->n  | -> n            tangent t from edge_begin to edge_end
///                   |
///                   | edge_begin
///
///     indentation d = (u_corner - u_edge) . n - clearance     law(d, d') >= 0 pushes the corner back along n
///     slide u_t = (u_corner - u_edge) . t                     Coulomb friction acts against it
///
/// u_edge is that of the point of the edge which the corner faces at rest. The corner may be a point of a column
/// between two floors (PlanPoint::other), whose force then acts on both. Reports `impact_force` [N] and `indentation`
/// [m], compression positive, and `friction_force` [N], along t on the edge's body.
template <ImpactLaw Law>
struct CornerGap {
  std::string name;  ///< Unique in its model.
  /// Where its peak is listed together with that of others; its own name if empty.
  std::string place{};
  Required<PlanPoint> corner;  ///< That hits the edge; a point of a body, or of a column between two.
  /// A diaphragm, a wall (a node with a direction), or `ground`.
  Required<NodeId> edge_of;
  Required<PlanPosition> edge_begin;  ///< One end of the edge, the corner on the left of the way from it.
  Required<PlanPosition> edge_end;    ///< Its other end.
  Law law;                            ///< Its force.
  CornerFriction friction{};          ///< Along the wall.
  /// > 0, <= 1: of the law's force, where several points of a face divide it.
  double share = 1.0;
  /// Effective mass for the law, > 0 kg. Zero stands for that of the corner: 1/m_n = sum of weight^2/mass.
  Mass effective_mass{};
  /// For tables.
  std::string corner_name = "corner", edge_name = "edge";
};

/// A corner gap without its law. CornerGap describes the fields.
struct CornerPlace {
  std::string name, place;             ///< Unique in its model; where its peak is listed.
  PlanPoint corner;                    ///< That hits the edge.
  NodeId edge_of;                      ///< The body of the edge.
  PlanPosition edge_begin, edge_end;   ///< The corner is on the left of the way between them.
  CornerFriction friction{};           ///< Along the wall.
  double share = 1.0;                  ///< > 0, <= 1: of the law's force.
  Mass effective_mass{};               ///< >= 0 kg; 0: that of the corner.
  std::string corner_name, edge_name;  ///< For tables.
};

/// Where a corner and an edge are, and how they move.
struct CornerGeometry {
  double clearance = 0.0;       ///< at rest, m
  PlanVector normal{};          ///< Unit vector from the body of the corner to that of the edge.
  double cross_mobility = 0.0;  ///< Mobility of one direction under a force along the other, 1/kg.
  CornerAndEdge motion{};       ///< The stiffness of its friction is 0 where it follows from the law.
};

/// Throws InputError unless both bodies are of this model and different, the edge has a length and the corner a
/// clearance >= 0, the coefficient of friction is from 0 to 1, and no other number is outside its range.
CornerGeometry check_corner(const Model& model, const CornerPlace& gap);
/// Registers the gap, and describes its element. Without parameters of the law reports show the contact's own.
ElementInfo register_corner(Model& model, const CornerPlace& gap, const CornerGeometry& geometry, std::string_view law,
                            std::vector<Parameter> parameters);

/// Adds the element to the block of its law.
template <ContactLaw Contact>
void add_corner(Model& model, ElementInfo info, const Contact& law, const CornerAndEdge& corner) {
  model.block<LinkBlock<Contact, CornerAndEdge>>().add(std::move(info), law, corner, corner.normal_mass);
}

/// Throws InputError for a bad parameter of gap, friction or law, unknown bodies, or a name that is taken.
template <ImpactLaw Law>
void add(Model& model, const CornerPlace& gap, const Law& law) {
  CornerGeometry geometry = check_corner(model, gap);
  law.check(Check{"CornerGap", gap.name});
  const double mass = gap.effective_mass.si() > 0.0 ? gap.effective_mass.si() : geometry.motion.normal_mass;
  const Repeated contact{as_any_contact(law.between(mass)), gap.share};
  if (!gap.friction.tangential_stiffness) {
    constexpr double of_tangent = 0.85, at_indentation = 0.01;  // m
    ContactState after;
    const Response response = contact.evaluate({ContactPhase::loaded, 1.0}, at_indentation, 0.0, after);
    geometry.motion.friction.tangential_stiffness = of_tangent * response.stiffness;
  }
  add_corner(model, register_corner(model, gap, geometry, name_of(law), parameters_of(law)), contact, geometry.motion);
}

/// As above.
template <ImpactLaw Law>
void add(Model& model, const CornerGap<Law>& gap) {
  add(model,
      CornerPlace{gap.name, gap.place, gap.corner, gap.edge_of, gap.edge_begin, gap.edge_end, gap.friction, gap.share,
                  gap.effective_mass, gap.corner_name, gap.edge_name},
      gap.law);
}

// Compiled in the library for moat's contacts, so that a script compiles faster.
extern template void add_corner(Model&, ElementInfo, const Repeated<AnyContact>&, const CornerAndEdge&);

}  // namespace moat
