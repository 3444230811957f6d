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

/// The stiffness k_t of a contact along the wall before it slides. A stiffness converts to it, a constant, and so does
/// a number, the ratio k_t/(dF/dd) to the elastic tangent of the normal law at each instant.
struct TangentialStiffness {
  Stiffness constant{};  ///< > 0 N/m; zero where the ratio is given.
  /// > 0, <= 1; zero where the constant is given. Mindlin (1949): 2 (1 - nu)/(2 - nu), which is 0.89 for nu = 0.2.
  double ratio = 0.0;

  TangentialStiffness(Stiffness k_t) : constant{k_t} {}          ///< The stiffness stays at `k_t`.
  TangentialStiffness(double of_tangent) : ratio{of_tangent} {}  ///< Follows the normal law.
};

/// Coulomb friction between a corner and an edge. A number converts to it: `.friction = 0.4`.
///
///     .friction = {0.4, 5e8 * N / m}      k_t is a constant
///     .friction = {0.4, 0.85}             k_t = 0.85 dF/dd, as in the contact of round bodies
struct CornerFriction {
  /// mu, from 0 to 1: concrete on concrete 0.4 to 0.6, steel 0.2 to 0.3. 0 is none.
  double coefficient = 0.0;
  /// k_t of the contact before it slides. Left out it is a constant, 0.85 times the tangent of the normal law at an
  /// indentation of 10 mm.
  std::optional<TangentialStiffness> tangential_stiffness{};

  /// Coefficient >= 0; stiffness along the wall, chosen by the law without one.
  CornerFriction(double friction_coefficient = 0.0, std::optional<TangentialStiffness> stiffness = {})
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
  Required<PlanPosition> edge_end;    ///< The other end of the edge.
  Law law;                            ///< Gives the force from the indentation.
  CornerFriction friction{};          ///< Along the wall.
  /// > 0, <= 1: of the law's force, where several points of a face divide it.
  double share = 1.0;
  /// Effective mass for the law, > 0 kg. Zero stands for that of the corner: 1/m_n = sum of weight^2/mass.
  Mass effective_mass{};
  /// Tables call them so.
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
  std::string corner_name, edge_name;  ///< Tables call them so.
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
ElementInfo register_corner(Model& model, const CornerPlace& gap, const CornerGeometry& geometry,
                            std::optional<LawAsGiven> law, ChangeableContact contact);

/// Returns the law as reports show it, with its friction and its share; nothing where the law shows nothing.
std::optional<LawAsGiven> with_friction(std::optional<LawAsGiven> law, const ContactFriction& friction, double share);

/// Adds the element to the block of its law.
template <ContactLaw Contact>
void add_corner(Model& model, ElementInfo info, const Contact& law, const CornerAndEdge& corner) {
  model.block<LinkBlock<Contact, CornerAndEdge>>().add(std::move(info), law, corner, corner.normal_mass);
}

/// A law at a corner.
template <ImpactLaw Law>
struct CornerLaw {
  Law law;                     ///< Gives the force of the whole contact.
  double effective_mass;       ///< kg
  double share;                ///< > 0, <= 1: of its force.
  bool gives_grip;             ///< Whether the stiffness of friction follows from it.
  ContactFriction friction{};  ///< Along the edge.

  /// Returns the contact of this corner.
  [[nodiscard]] auto contact() const { return Repeated{as_any_contact(law.between(effective_mass)), share}; }
  /// Returns the friction, with the stiffness that this law gives.
  [[nodiscard]] ContactFriction acting_friction() const {
    ContactFriction acting = friction;
    constexpr double of_tangent = 0.85, at_indentation = 0.01, at_speed = 1.0;  // m, m/s
    if (gives_grip) {
      const auto whole = contact();
      ContactState after;
      acting.tangential_stiffness =
          of_tangent *
          whole.evaluate(whole.next_regime({}, at_indentation, at_speed), at_indentation, 0.0, after).stiffness;
    }
    return acting;
  }
  /// Returns it as reports show it.
  [[nodiscard]] std::optional<LawAsGiven> as_given() const {
    return with_friction(law_as_given(law), acting_friction(), share);
  }
  /// Returns the parameters that can be changed.
  [[nodiscard]] ChangeableContact changeable() const {
    const auto change = [corner_law = *this](ElementBlock& block, std::size_t e, const ContactChange& wanted) {
      CornerLaw changed = corner_law;
      changed.law = changed_law(corner_law.law, wanted, block.info(e).name);
      const auto contact = changed.contact();
      auto& corners = dynamic_cast<LinkBlock<std::remove_const_t<decltype(contact)>, CornerAndEdge>&>(block);
      CornerAndEdge motion = corners.ends()[e];
      motion.friction = changed.acting_friction();
      corners.replace(e, changed_gap(block.info(e), wanted, changed.as_given(), changed.changeable()), contact, motion);
    };
    return {std::string{name_of(law)}, has_stiffness(law), restitution_of_law(law), change};
  }
};

/// Throws InputError for a bad parameter of gap, friction or law, unknown bodies, or a name that is taken.
template <ImpactLaw Law>
void add(Model& model, const CornerPlace& gap, const Law& law) {
  CornerGeometry geometry = check_corner(model, gap);
  law.check(Check{"CornerGap", gap.name});
  const CornerLaw<Law> corner{
      .law = law,
      .effective_mass = gap.effective_mass.si() > 0.0 ? gap.effective_mass.si() : geometry.motion.normal_mass,
      .share = gap.share,
      .gives_grip = !gap.friction.tangential_stiffness,
      .friction = geometry.motion.friction};
  geometry.motion.friction = corner.acting_friction();
  add_corner(model, register_corner(model, gap, geometry, corner.as_given(), corner.changeable()), corner.contact(),
             geometry.motion);
}

/// Adds the gap to the model. Throws InputError for a bad parameter, unknown bodies, or a name that is taken.
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
