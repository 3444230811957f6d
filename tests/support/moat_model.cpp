#include "moat_model.hpp"

#include <stdexcept>

#include "elements/contact/gap.hpp"
#include "elements/line/lead_rubber_bearing.hpp"
#include "elements/line/shear_spring.hpp"
#include "elements/line/storey.hpp"
#include "elements/line/viscous_damper.hpp"
#include "materials/contact/impact_laws.hpp"
#include "materials/storeys/yielding_storey.hpp"
#include "structures/moat.hpp"

namespace moat::testing {
namespace {

using namespace units;

// Calls add_gap(law) with moat's law of that kind.
template <class AddGap>
void with_law(const PlainLaw& law, const AddGap& add_gap) {
  const Stiffness linear = law.stiffness * (N / m);
  const HertzStiffness hertz = law.stiffness * (N / m_3_2);
  const double e = law.restitution;
  const bool pulls = law.acts == PlainDamping::may_pull;
  switch (law.kind) {
    case PlainLawKind::linear_elastic:
      return add_gap(LinearElastic{.stiffness = linear});
    case PlainLawKind::kelvin:
      return add_gap(Kelvin{.stiffness = linear, .restitution = e, .may_pull = pulls});
    case PlainLawKind::anagnostopoulos:
      return add_gap(Anagnostopoulos{.stiffness = linear, .restitution = e, .may_pull = pulls});
    case PlainLawKind::kelvin_by_damping_ratio:
      return add_gap(KelvinByDampingRatio{.stiffness = linear, .damping_ratio = law.damping_ratio, .may_pull = pulls});
    case PlainLawKind::modified_linear_viscoelastic:
      return add_gap(ModifiedLinearViscoelastic{.stiffness = linear, .restitution = e});
    case PlainLawKind::exact_kelvin:
      return add_gap(ExactKelvin{.stiffness = linear, .restitution = e, .may_pull = pulls});
    case PlainLawKind::hertz:
      return add_gap(Hertz{.stiffness = hertz});
    case PlainLawKind::hertz_damp:
      return add_gap(HertzDamp{.stiffness = hertz, .restitution = e, .may_pull = pulls});
    case PlainLawKind::lankarani_nikravesh:
      return add_gap(LankaraniNikravesh{.stiffness = hertz, .restitution = e, .may_pull = pulls});
    case PlainLawKind::hunt_crossley:
      return add_gap(HuntCrossley{.stiffness = hertz, .restitution = e, .may_pull = pulls});
    case PlainLawKind::gonthier:
      return add_gap(Gonthier{.stiffness = hertz, .restitution = e, .may_pull = pulls});
    case PlainLawKind::ye_2009:
      return add_gap(Ye2009{.stiffness = hertz, .restitution = e, .may_pull = pulls});
    case PlainLawKind::hu_guo:
      return add_gap(HuGuo{.stiffness = hertz, .restitution = e, .may_pull = pulls});
    case PlainLawKind::modified_hertz_damp:
      return add_gap(ModifiedHertzDamp{.stiffness = hertz, .restitution = e, .may_pull = pulls});
    case PlainLawKind::exact_hertz_damp:
      return add_gap(ExactHertzDamp{.stiffness = hertz, .restitution = e, .may_pull = pulls});
    case PlainLawKind::nonlinear_viscoelastic:
      return add_gap(NonlinearViscoelastic{.stiffness = hertz, .restitution = e});
    case PlainLawKind::modified_hertz_damp_printed:
      return add_gap(ModifiedHertzDampPrinted{.stiffness = hertz,
                                              .restitution = e,
                                              .approach_only = law.acts == PlainDamping::approach_only,
                                              .may_pull = pulls});
  }
  throw std::logic_error{"moat_model: a law without a case"};
}

NodeId node_id(int plain) { return plain == plain_ground ? ground : NodeId{plain}; }

MemberPoint member_point(const PlainPoint& plain) {
  if (plain.share == 0.0) return node_id(plain.node);
  return {node_id(plain.node), node_id(plain.other), plain.share};
}

}  // namespace

Model moat_model(const PlainModel& plain) {
  Model model;
  const auto is_wall = [&](std::size_t node) {
    for (const PlainSpring& spring : plain.springs)
      if (spring.kind == PlainSpring::Kind::wall && spring.upper == static_cast<int>(node)) return true;
    return false;
  };
  for (std::size_t i = 0; i < plain.nodes.size(); ++i) {
    const PlainNode& node = plain.nodes[i];
    if (!is_wall(i)) {
      add(model, Node{.name = node.name,
                      .mass = node.mass * kg,
                      .initial_displacement = node.displacement * units::m,
                      .initial_velocity = node.velocity * (units::m / s)});
      continue;
    }
    for (const PlainSpring& spring : plain.springs)
      if (spring.upper == static_cast<int>(i))
        add_wall(model,
                 FlexibleWall{.mass = node.mass * kg,
                              .stiffness = spring.stiffness * (N / units::m),
                              .damping = spring.damping * (N * s / units::m)},
                 spring.name, NodeId{0}, 1.0 * units::m);
  }
  for (const PlainSpring& spring : plain.springs)
    if (spring.kind == PlainSpring::Kind::storey)
      add(model, ShearSpring{.name = spring.name,
                             .lower = node_id(spring.lower),
                             .upper = node_id(spring.upper),
                             .stiffness = spring.stiffness * (N / units::m)});
  for (const PlainDashpot& dashpot : plain.dashpots)
    add(model, ViscousDamper{.name = dashpot.name,
                             .lower = node_id(dashpot.lower),
                             .upper = node_id(dashpot.upper),
                             .damping = dashpot.damping * (N * s / units::m)});
  for (const PlainBearing& bearing : plain.bearings) {
    if (bearing.kind == PlainBearing::Kind::storey) {
      const double stiffness = bearing.yield_force / bearing.yield_displacement;
      add(model, Storey<YieldingStorey>{.name = bearing.name,
                                        .lower = node_id(bearing.lower),
                                        .upper = node_id(bearing.upper),
                                        .law = {.stiffness = stiffness * (N / units::m),
                                                .yield_force = bearing.yield_force * N,
                                                .hardening_ratio = bearing.post_yield_stiffness / stiffness}});
      continue;
    }
    add(model, LeadRubberBearing{.name = bearing.name,
                                 .lower = node_id(bearing.lower),
                                 .upper = node_id(bearing.upper),
                                 .yield_force = bearing.yield_force * N,
                                 .yield_displacement = bearing.yield_displacement * units::m,
                                 .post_yield_stiffness = bearing.post_yield_stiffness * (N / units::m)});
  }
  for (const PlainGap& gap : plain.gaps)
    with_law(gap.law, [&](const auto& law) {
      using Law = std::remove_cvref_t<decltype(law)>;
      add(model, Gap<Law>{.name = gap.name,
                          .place = gap.place,
                          .left = member_point(gap.left),
                          .right = member_point(gap.right),
                          .clearance = gap.clearance * units::m,
                          .law = law});
    });
  return model;
}

std::string_view moat_law_name(PlainLawKind kind) {
  std::string_view name;
  with_law({.kind = kind}, [&](const auto& law) { name = law.name; });
  return name;
}

GroundMotion moat_motion(const PlainMotion& plain) { return {"random", plain.time_step, plain.samples}; }

}  // namespace moat::testing
