#include "model/weight/outside_forces.hpp"

#include <algorithm>

#include "model/model.hpp"

namespace moat {

OutsideForces::OutsideForces(const Model& model, std::span<const NodeId> nodes, std::span<const ElementId> bearings,
                             double level) {
  const auto inside = [&](NodeId node) {
    return node != ground && std::ranges::any_of(nodes, [&](NodeId each) {
             return std::ranges::count(model.nodes_of_body(each), node) > 0;
           });
  };
  const auto height = [&](NodeId node) { return model.body(node).height - level; };
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const ElementBlock& block = *model.blocks()[b];
    for (std::size_t e = 0; e < block.size(); ++e) {
      const ElementInfo& info = block.info(e);
      if (info.joined() != nullptr || inside(info.first) == inside(info.second) ||
          std::ranges::count(bearings, ElementId{b, e}) > 0)
        continue;
      const bool on_second = inside(info.second);
      double arm = height(on_second ? info.second : info.first);
      if (const MemberEnds* ends = info.member_ends()) {
        const MemberPoint& point = on_second ? ends->second : ends->first;
        if (!point.is_node()) arm = (1.0 - point.share) * height(point.node) + point.share * height(point.other);
      }
      if (arm != 0.0) forces_.push_back({{b, e}, on_second ? -arm : arm});
    }
  }
}

// The force of an element on its first end is that of its law along its direction.
PlanVector OutsideForces::moment(const Model& model, const Elements& elements, bool of_rates) const {
  PlanVector sum{};
  for (const auto& [element, arm] : forces_) {
    const auto [b, e] = element;
    const ElementInfo& info = model.blocks()[b]->info(e);
    const ElementResults results = elements[b]->results();
    if (!results.plan.forces.empty()) {
      sum += arm * (of_rates ? results.plan.force_rates : results.plan.forces)[e];
      continue;
    }
    const double force = (of_rates ? results.line.force_rates : results.line.forces)[e];
    if (const CornerPair* corner = info.corner_pair()) {
      const ContactView contact = elements[b]->contact(e);
      const double friction = of_rates ? contact.friction_force_rate : contact.friction_force;
      sum += arm * (force * corner->normal + friction * turned_left(corner->normal));
    } else if (!model.is_plan()) {
      sum += PlanVector{arm * force, 0.0};
    } else if (const PlanPlaces* places = info.plan_places()) {
      sum += arm * force * places->direction;
    }
  }
  return sum;
}

}  // namespace moat
