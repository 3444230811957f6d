#include "moat_model.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "impact_cases.hpp"
#include "moat.hpp"

namespace moat::testing {
namespace {

using namespace units;

// The names of moat's laws in the order of PlainLawKind.
using LawNames = std::array<std::string_view, plain_law_kinds>;
constexpr LawNames law_names{"LinearElastic",
                             "Kelvin",
                             "Anagnostopoulos",
                             "KelvinByDampingRatio",
                             "ModifiedLinearViscoelastic",
                             "ExactKelvin",
                             "Hertz",
                             "HertzDamp",
                             "LankaraniNikravesh",
                             "HuntCrossley",
                             "Gonthier",
                             "Ye2009",
                             "HuGuo",
                             "ModifiedHertzDamp",
                             "ExactHertzDamp",
                             "NonlinearViscoelastic",
                             "ModifiedHertzDampPrinted"};

// Calls add_gap(law) with moat's law of that kind.
template <class AddGap>
void with_law(const PlainLaw& plain, const AddGap& add_gap) {
  const std::string_view name = law_names.at(static_cast<std::size_t>(plain.kind));
  AllImpactLaws::for_each([&]<class Law>() {
    if (Law::name != name && alias_of<Law>() != name) return;
    Law law = impact_law<Law>(plain.stiffness, plain.restitution);
    if constexpr (requires { law.damping_ratio; }) law.damping_ratio = plain.damping_ratio;
    if constexpr (requires { law.may_pull; }) law.may_pull = plain.acts == PlainDamping::may_pull;
    if constexpr (requires { law.approach_only; }) law.approach_only = plain.acts == PlainDamping::approach_only;
    add_gap(law);
  });
}

NodeId node_id(int plain) { return plain == plain_ground ? ground : NodeId{plain}; }

MemberPoint member_point(const PlainPoint& plain) {
  if (plain.share == 0.0) return node_id(plain.node);
  return {node_id(plain.node), node_id(plain.other), plain.share};
}

// All springs of one name are the matrix of a frame on the node that is never an upper one.
void add_frames(Model& model, const PlainModel& plain) {
  std::map<std::string, std::vector<PlainSpring>> frames;
  for (const PlainSpring& spring : plain.springs)
    if (spring.kind == PlainSpring::Kind::frame) frames[spring.name].push_back(spring);
  for (const auto& [name, springs] : frames) {
    std::vector<int> floors;
    for (const PlainSpring& spring : springs)
      if (std::ranges::find(floors, spring.upper) == floors.end()) floors.push_back(spring.upper);
    const auto size = static_cast<Eigen::Index>(floors.size());
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
    const auto row = [&](int node) { return std::ranges::find(floors, node) - floors.begin(); };
    for (const PlainSpring& spring : springs) {
      const auto upper = row(spring.upper), lower = row(spring.lower);
      stiffness(upper, upper) += spring.stiffness;
      if (lower == size) continue;
      stiffness(lower, lower) += spring.stiffness;
      stiffness(upper, lower) -= spring.stiffness;
      stiffness(lower, upper) -= spring.stiffness;
    }
    LinearStructure frame{.name = name, .nodes = {}, .stiffness = stiffness};
    for (const int floor : floors) frame.nodes.push_back(NodeId{floor});
    const auto lowest = std::ranges::find_if(springs, [&](const PlainSpring& each) { return row(each.lower) == size; });
    if (lowest->lower != plain_ground) {
      frame.base = {NodeId{lowest->lower}};
      frame.carried = Eigen::MatrixXd::Ones(size, 1);
    }
    add(model, frame);
  }
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
  add_frames(model, plain);
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
