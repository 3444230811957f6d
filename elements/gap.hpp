// A gap that can close: impact between two nodes.
#pragma once

#include "elements/link_block.hpp"
#include "elements/link_checks.hpp"
#include "model/model.hpp"

namespace moat {

/// What can stand in a Gap: parameters that check themselves and make the law between two bodies.
template <class Law>
concept ImpactLaw = requires(const Law& law, const Check& check, double effective_mass) {
  law.check(check);
  { law.between(effective_mass) } -> LawWithRegimes;
};

/// A gap between two nodes, or a node and the fixed ground, that pound when it closes.
///
///     [ left ]  |<-- clearance -->|  [ right ]         at rest; x to the right
///
///     indentation d = u_left - u_right - clearance;  touching where d > 0
///     law(d, d') >= 0 pushes `left` to the left and `right` to the right
///
/// Reports `impact_force` [N], compression positive, under its name and its peak under `place`.
template <ImpactLaw Law>
struct Gap {
  std::string name;
  /// Where its peak is listed together with that of other gaps; its own name if empty.
  std::string place{};
  Required<NodeId> left;
  Required<NodeId> right;
  /// > 0 m, free distance at rest.
  Required<Length> clearance;
  Law law;
};

/// Throws InputError for a bad parameter of gap or law, unknown or equal nodes, or a name that is taken.
template <ImpactLaw Law>
void add(Model& model, const Gap<Law>& gap) {
  const Check check = check_link(model, "Gap", gap.name, {"left", gap.left}, {"right", gap.right});
  check.positive("clearance", gap.clearance, "Give the free distance at rest.");
  gap.law.check(check);
  const double effective_mass = model.effective_mass(gap.left, gap.right);
  const auto law = gap.law.between(effective_mass);
  model.register_element("Gap", gap.name);
  model.block<LinkBlock<std::remove_const_t<decltype(law)>>>().add(
      {.name = gap.name,
       .place = gap.place.empty() ? gap.name : gap.place,
       .kind = ElementKind::gap,
       .first = gap.right,
       .second = gap.left,
       .offset = gap.clearance.si(),
       .deformation_quantity = "indentation",
       .force_quantity = "impact_force"},
      law, effective_mass);
}

}  // namespace moat
