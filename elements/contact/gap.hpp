// A gap that can close: impact between two nodes.
#pragma once

#include <optional>

#include "elements/block/link_checks.hpp"
#include "materials/contact/any_contact.hpp"
#include "materials/contact/changed_law.hpp"
#include "model/with_contacts.hpp"

namespace moat {

/// A law for a Gap: parameters that check themselves and make the contact between two bodies.
template <class Law>
concept ImpactLaw = requires(const Law& law, const Check& check, double effective_mass) {
  law.check(check);
  { law.between(effective_mass) } -> ContactLaw;
};

/// A gap between two nodes, or a node and the fixed ground, that pound when it closes.
///
///     [ left ]  |<-- clearance -->|  [ right ]         at rest; x to the right
///
///     indentation d = u_left - u_right - clearance;  touching where d > 0
///     law(d, d') >= 0 pushes `left` to the left and `right` to the right
///
/// Either side may be a point on a column between two floors, where floors of neighbouring buildings stand at unequal
/// heights: `MemberPoint{floor_2, floor_3, 0.4}` is 40 % of the way up from floor 2; the force then acts on both
/// floors.
///
/// Reports `impact_force` [N], compression positive, and `indentation` [m] under its name and their peaks under
/// `place`. The effective mass that a law may need is 1/m = sum of weight^2 / mass over the nodes of both sides, where
/// a node on both sides counts once with the difference of its weights; the ground's mass is infinite.
template <ImpactLaw Law>
struct Gap {
  std::string name;  ///< Unique in its model.
  /// Where its peak is listed together with that of other gaps; its own name if empty.
  std::string place{};
  Required<MemberPoint> left;   ///< The body on the left.
  Required<MemberPoint> right;  ///< The body on the right.
  /// >= 0 m, free distance at rest; 0 is wall to wall.
  Required<Length> clearance;
  Law law;  ///< Gives the force from the indentation.
};

/// A gap without its law.
struct GapPlace {
  const std::string& name;   ///< Unique in its model.
  const std::string& place;  ///< Where its peak is listed; its own name if empty.
  MemberPoint left, right;   ///< Both bodies.
  Length clearance;          ///< >= 0 m.
};

/// Throws InputError unless all nodes of both points are of this model, shares are from 0 to below 1, two ends at nodes
/// are at different ones, and the clearance is not negative; returns the Check that names the gap.
Check check_gap(const Model& model, const GapPlace& gap);

/// Returns the effective mass of two points, kg. Throws InputError if they are the same point.
double effective_mass(const Model& model, const Check& check, const MemberPoint& first, const MemberPoint& second);

/// Registers the gap, and describes its element. A gap at a point between nodes is drawn at the height of the end that
/// is a node, else of the left one. `law`: as reports show it, none for the contact's own.
ElementInfo register_gap(Model& model, const GapPlace& gap, std::optional<LawAsGiven> law, ChangeableContact contact);

/// Returns a gap with another law, and with its clearance changed; the edge of a corner moves along its normal.
ElementInfo changed_gap(ElementInfo gap, const ContactChange& change, std::optional<LawAsGiven> law,
                        ChangeableContact contact);

/// Adds the element to the block of its law.
template <ContactLaw Contact>
void add_contact(Model& model, ElementInfo info, const Contact& law, double effective_mass, const MemberPoint& left,
                 const MemberPoint& right) {
  if (left.is_node() && right.is_node() && !left.node.is_follower() && !right.node.is_follower())
    model.block<LinkBlock<Contact>>().add(std::move(info), law, effective_mass);
  else
    model.block<LinkBlock<Contact, WeightedEnds>>().add(std::move(info), law, WeightedEnds{model, right, left},
                                                        effective_mass);
}

/// Puts another contact into the place of that of a gap which add_contact() has added.
template <ContactLaw Contact>
void replace_contact(ElementBlock& block, std::size_t element, ElementInfo info, const Contact& law) {
  if (auto* between_nodes = dynamic_cast<LinkBlock<Contact>*>(&block))
    between_nodes->replace(element, std::move(info), law);
  else
    dynamic_cast<LinkBlock<Contact, WeightedEnds>&>(block).replace(element, std::move(info), law);
}

/// Returns the law as the script gave it. Reports show it with its restitution, and not the contact made of it.
template <ImpactLaw Law>
std::optional<LawAsGiven> law_as_given(const Law& law) {
  if constexpr (requires { law.parameters(); })
    return LawAsGiven{std::string{name_of(law)}, law.parameters()};
  else
    return std::nullopt;
}

/// Returns the law with another stiffness and restitution. Throws InputError where it refuses them.
template <ImpactLaw Law>
Law changed_law(const Law& law, const ContactChange& change, const std::string& gap) {
  Law changed = with_restitution_change(with_stiffness_factor(law, change.stiffness_factor), change.restitution_change);
  changed.check(Check{"Gap", gap});
  return changed;
}

/// Returns the parameters of a gap with this law that can be changed. effective_mass: of its two bodies, kg.
template <ImpactLaw Law>
ChangeableContact changeable_gap(const Law& law, double effective_mass) {
  const auto change = [law, effective_mass](ElementBlock& block, std::size_t e, const ContactChange& wanted) {
    const Law changed = changed_law(law, wanted, block.info(e).name);
    replace_contact(block, e,
                    changed_gap(block.info(e), wanted, law_as_given(changed), changeable_gap(changed, effective_mass)),
                    as_any_contact(changed.between(effective_mass)));
  };
  return {std::string{name_of(law)}, has_stiffness(law), restitution_of_law(law), change};
}

/// Throws InputError for a bad parameter of gap or law, unknown nodes, two ends at the same point, or a name that is
/// taken.
template <ImpactLaw Law>
void add(Model& model, const Gap<Law>& gap) {
  const GapPlace place{gap.name, gap.place, gap.left, gap.right, gap.clearance};
  const Check check = check_gap(model, place);
  gap.law.check(check);
  const double mass = effective_mass(model, check, place.left, place.right);
  add_contact(model, register_gap(model, place, law_as_given(gap.law), changeable_gap(gap.law, mass)),
              as_any_contact(gap.law.between(mass)), mass, place.left, place.right);
}

// Compiled in the library for moat's contacts, so that a script compiles in a third of the time.
extern template void add_contact(Model&, ElementInfo, const AnyContact&, double, const MemberPoint&,
                                 const MemberPoint&);
extern template void replace_contact(ElementBlock&, std::size_t, ElementInfo, const AnyContact&);

}  // namespace moat
