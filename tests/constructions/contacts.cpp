// Laws of impact, gaps and corners.
#include <gtest/gtest.h>

#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

template <class Law>
std::function<void()> gap(const Law& law) {
  return [law] { add_wall_gap(law); };
}

constexpr HertzStiffness hertz = 1e9 * N / m_3_2;
constexpr Stiffness linear = 1e9 * N / m;

// A body that flies towards another at rest, and hits it elastically.
void expect_elastic_impact(double mass, double other) {
  Model model;
  const NodeId left = add(model, Node{.name = "left", .mass = mass * kg, .initial_velocity = 1 * m / s, .free = true});
  const NodeId right = add(model, Node{.name = "right", .mass = other * kg, .free = true});
  const double lighter = 1.0 / (1.0 / mass + 1.0 / other);
  // The contact lasts pi sqrt(m/k) = 10 ms.
  add(model, Gap<LinearElastic>{.name = "gap",
                                .left = left,
                                .right = right,
                                .clearance = 0 * m,
                                .law = {.stiffness = lighter * pi * pi / 1e-4 * N / m}});
  Transient analysis{model, still_ground(0.1 * s)};
  analysis.run();
  EXPECT_NEAR(analysis.state().velocity(left), (mass - other) / (mass + other), 1e-5);
  EXPECT_NEAR(analysis.state().velocity(right), 2.0 * mass / (mass + other), 1e-5);
}

// A slab at 10 cm from a wall, changed.
template <class Change>
std::function<void()> corner(Change change) {
  return [change] {
    Model model;
    const DiaphragmId slab = add(model, Diaphragm{.name = "slab", .mass = 100 * tonne, .size = {20 * m, 12 * m}});
    CornerGap<Hertz> gap{.name = "east",
                         .corner = PlanPoint{slab, {10 * m, 6 * m}},
                         .edge_of = ground,
                         .edge_begin = PlanPosition{10.1 * m, -8 * m},
                         .edge_end = PlanPosition{10.1 * m, 8 * m},
                         .law = {.stiffness = hertz}};
    change(gap);
    add(model, gap);
  };
}

std::function<void()> changed_contacts(const ContactChange& change) {
  return [change] {
    Model model;
    const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne, .free = true});
    add(model, Gap<HertzDamp>{.name = "west",
                              .left = body,
                              .right = ground,
                              .clearance = 1 * m,
                              .law = {.stiffness = hertz, .restitution = 0.6}});
    static_cast<void>(with_contacts(model, change));
  };
}

Constructions impact_laws() {
  const Restitution good = 0.65;
  return {
      {"hertz of infinite stiffness",
       gap(Hertz{.stiffness = infinite * N / m_3_2}),
       {"Gap \"west\"", "stiffness", "inf N/m^1.5", "> 0 N/m^1.5 and finite", "division by zero"}},
      {"linear contact without stiffness",
       gap(LinearElastic{.stiffness = 0 * N / m}),
       {"Gap \"west\"", "stiffness", "0 N/m", "> 0 N/m and finite", "Check its sign and its unit"}},
      {"kelvin that gains energy",
       gap(Kelvin{.stiffness = linear, .restitution = 1.1}),
       {"Gap \"west\"", "restitution", "1.1", "> 0 and <= 1",
        "It is the speed after the impact over the speed before; 1"}},
      {"kelvin that drives",
       gap(KelvinByDampingRatio{.stiffness = linear, .damping_ratio = -0.1}),
       {"Gap \"west\"", "damping_ratio", "-0.1", ">= 0 and finite", "Give a number in this range"}},
      {"kelvin that sticks",
       gap(KelvinByDampingRatio{.stiffness = linear, .damping_ratio = 1, .may_pull = true}),
       {"Gap \"west\"", "damping_ratio", "1", "< 1 where may_pull is true",
        "A contact that pulls and is damped critically never ends"}},
      {"a dashpot of approach that pulls",
       gap(ModifiedHertzDampPrinted{.stiffness = hertz, .restitution = 0.6, .may_pull = true}),
       {"Gap \"west\"", "may_pull", "1", "false where approach_only is true",
        "A dashpot that acts on approach only never pulls"}},
      {"a printed law that never lets go",
       gap(ModifiedHertzDampPrinted{.stiffness = hertz, .restitution = 0.4, .approach_only = false, .may_pull = true}),
       {"Gap \"west\"", "restitution", "0.4", ">= 0.409 where the contact may pull",
        "A contact that pulls and is damped critically never ends"}},
      {"nonlinear contact of no number",
       gap(NonlinearViscoelastic{.stiffness = hertz, .restitution = not_a_number}),
       {"Gap \"west\"", "restitution", "nan", "from 0.001 to 1",
        "It is the speed after the impact over the speed before; 1"}},
      {"crushing without indentation",
       gap(BilinearImpact{.stiffness = hertz, .restitution = good, .expected_indentation = 0 * m}),
       {"Gap \"west\"", "expected_indentation", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"crushing that begins late",
       gap(BilinearImpact{.stiffness = hertz, .restitution = good, .expected_indentation = 2 * cm, .yield_share = 0.6}),
       {"Gap \"west\"", "yield_share", "0.6", "> 0 and <= 0.5", "0.1 is usual"}},
      {"a law by a name that is misspelt",
       gap(NamedImpactLaw{.name = "hertz_dmap", .hertz_stiffness = hertz}),
       {"Gap \"west\"", "impact law", "hertz_dmap", "Choose one of", "hertz_damp, hu_guo"}},
      {"a law by name with the other stiffness",
       gap(NamedImpactLaw{.name = "kelvin", .hertz_stiffness = hertz}),
       {"Gap \"west\"", "linear_stiffness", "0 N/m", "> 0 N/m and finite", "The law kelvin needs it"}},
      {"restitution that falls to nothing",
       gap(ViscousHertzLaw<GonthierFactor>{.stiffness = hertz,
                                           .restitution = FallingRestitution{.restitution = 0.005}}),
       {"Gap \"west\"", "restitution", "0.005", "from 0.01 to 1", "It is that at at_speed"}},
      {"restitution that rises with the speed",
       gap(HertzDamp{.stiffness = hertz,
                     .restitution = MeasuredRestitution{{RestitutionAtSpeed{1 * m / s, 0.5},
                                                         RestitutionAtSpeed{2 * m / s, 0.6}}}}),
       {"Gap \"west\"", "points[1].restitution", "0.6", "<= 0.5, the restitution before it",
        "Restitution does not grow with the speed; take a mean of"}},
      {"restitution measured nowhere",
       gap(ExactKelvin{.stiffness = linear, .restitution = MeasuredRestitution{}}),
       {"Gap \"west\"", "restitution", "no points", "Give", "speeds and restitutions"}},
      {"restitution measured at rest",
       gap(ModifiedLinearViscoelastic{.stiffness = linear, .restitution = MeasuredRestitution{{{0 * m / s, 0.5}}}}),
       {"Gap \"west\"", "points[0].speed", "0 m/s", "> 0 m/s and finite", "Check its sign and its unit"}},
      {"a feather and a mountain", [] { expect_elastic_impact(1e-6, 1e9); }},
      {"a mountain and a feather", [] { expect_elastic_impact(1e9, 1e-6); }},
      {"two specks of equal mass", [] { expect_elastic_impact(1e-9, 1e-9); }},
  };
}

Constructions gaps() {
  return {
      {"a gap that overlaps",
       [] { add_wall_gap(Hertz{.stiffness = hertz}, -5 * cm); },
       {"Gap \"west\"", "clearance", "-0.05 m", ">= 0 m and finite",
        "Give the free distance at rest, 0 m for wall to wall; a"}},
      {"a gap between a body and itself",
       [] {
         Model model;
         const NodeId body = add(model, Node{.name = "body", .mass = 1 * kg});
         add(model, Gap<Hertz>{.name = "west", .left = body, .right = body, .clearance = 0 * m, .law = {hertz}});
       },
       {"Gap \"west\"", "left and right", "\"body\"", "An element joins", "two different nodes"}},
      {"a gap at the end of a column",
       [] {
         Model model;
         const NodeId body = add(model, Node{.name = "body", .mass = 1 * kg});
         add(model, Gap<Hertz>{.name = "west",
                               .left = MemberPoint{ground, body, 1.0},
                               .right = ground,
                               .clearance = 0 * m,
                               .law = {hertz}});
       },
       {"Gap \"west\"", "left.share", "1", ">= 0 and < 1",
        "It is the way from the first node to the second; take the"}},
      {"a corner behind its wall",
       corner([](auto& gap) { std::swap(gap.edge_begin, gap.edge_end); }),
       {"CornerGap \"east\"", "clearance", "-0.1 m", ">= 0 m and finite",
        "Overlap at rest: the corner must be on the left of the way"}},
      {"an edge without length",
       corner([](auto& gap) { gap.edge_end = gap.edge_begin; }),
       {"CornerGap \"east\"", "edge_end - edge_begin", "0", "a vector of finite length > 0",
        "Give the direction along which the element acts, for"}},
      {"a corner that sticks",
       corner([](auto& gap) { gap.friction = 1.1; }),
       {"CornerGap \"east\"", "friction", "1.1", "from 0 to 1",
        "Concrete on concrete has 0.4 to 0.6, steel 0.2 to 0.3"}},
      {"friction without grip",
       corner([](auto& gap) {
         gap.friction = CornerFriction{0.4, TangentialStiffness{0.0}};
       }),
       {"CornerGap \"east\"", "tangential_stiffness", "0 N/m", "> 0 N/m and finite",
        "Give the stiffness before sliding, or leave it out for 0.85"}},
      {"a corner that hits with nothing",
       corner([](auto& gap) { gap.share = 0; }),
       {"CornerGap \"east\"", "share", "0", "> 0 and <= 1", "Give a number in this range"}},
      {"a corner of negative mass",
       corner([](auto& gap) { gap.effective_mass = -1 * kg; }),
       {"CornerGap \"east\"", "effective_mass", "-1 kg", ">= 0 kg and finite", "Check its sign and its unit"}},
      {"an edge of the slab itself",
       corner([](auto& gap) { gap.edge_of = gap.corner.value().of; }),
       {"CornerGap \"east\"", "corner and edge_of", "the same body", "An element joins points", "two bodies"}},
      {"contacts changed to nothing",
       changed_contacts({.stiffness_factor = 0}),
       {"ContactChange", "stiffness_factor", "0", "> 0 and finite", "Give a number in this range"}},
      {"contacts beyond elastic",
       changed_contacts({.restitution_change = 2}),
       {"ContactChange", "restitution_change", "2", "from -1 to 1", "Give a number in this range"}},
      {"clearances turned over",
       changed_contacts({.clearance_factor = -1}),
       {"ContactChange", "clearance_factor", "-1", ">= 0 and finite", "Give a number in this range"}},
      {"soil changed where there is none",
       changed_contacts({.soil_factor = 2}),
       {"ContactChange", "soil_factor", "2", "left out here", "The model has no soil: give FlexibleWall::backfill"}},
  };
}

}  // namespace

Constructions contacts() {
  Constructions all = impact_laws();
  const Constructions more = gaps();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

Constructions contact_estimates() {
  const Approach approach{.mass = 100 * tonne, .speed = 1 * m / s};
  return {
      {"a hit wider than the slab",
       [] {
         static_cast<void>(axial_stiffness_of_slab(
             SlabAlongHit{.length = 20 * m, .width = 10 * m, .thickness = 20 * cm, .contact_width = 11 * m}));
       },
       {"axial_stiffness_of_slab", "contact_width", "11 m", "> 0 m and <= width = 10 m",
        "Leave it out for the whole edge"}},
      {"a slab edge of no mass",
       [] { static_cast<void>(contact_stiffness_of_slab_edge(SlabEdge{.mass = 0 * kg})); },
       {"contact_stiffness_of_slab_edge", "mass", "0 kg", "> 0 kg and finite", "Check its sign and its unit"}},
      {"concrete that keeps its volume",
       [] {
         static_cast<void>(contact_stiffness_of_slab_edge(
             SlabEdge{.mass = 100 * tonne, .material = Concrete{.poissons_ratio = 0.5}}));
       },
       {"contact_stiffness_of_slab_edge", "poissons_ratio", "0.5", ">= 0 and < 0.5", "Concrete has about 0.2"}},
      {"concrete of air",
       [] {
         static_cast<void>(wave_return_time(SlabAlongHit{
             .length = 20 * m, .width = 10 * m, .thickness = 20 * cm, .material = Concrete{.density = 0 * kg / m_3}}));
       },
       {"wave_return_time", "density", "0 kg/m^3", "> 0 kg/m^3 and finite", "Check its sign and its unit"}},
      {"an edge without thickness",
       [] { static_cast<void>(contact_stiffness_of_vertical_edge(VerticalEdge{.thickness = 0 * m})); },
       {"contact_stiffness_of_vertical_edge", "thickness", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"a column hit at its end",
       [] {
         static_cast<void>(
             stiffness_of_column_hit(ColumnHit{.height = 3 * m, .depth = 0.5 * m, .width = 0.5 * m, .share = 1}));
       },
       {"stiffness_of_column_hit", "share", "1", "> 0 and < 1", "A hit at a floor is a Gap between nodes"}},
      {"a column cracked away",
       [] {
         static_cast<void>(stiffness_of_column_hit(
             ColumnHit{.height = 3 * m, .depth = 0.5 * m, .width = 0.5 * m, .cracked_share = 0}));
       },
       {"stiffness_of_column_hit", "cracked_share", "0", "> 0 and <= 1", "0.3 to 0.5 where concrete has cracked"}},
      {"no column",
       [] {
         static_cast<void>(
             stiffness_of_column_hit(ColumnHit{.height = 3 * m, .depth = 0.5 * m, .width = 0.5 * m, .count = 0}));
       },
       {"stiffness_of_column_hit", "count", "0", ">= 1", "Give a number in this range"}},
      {"a hit wider than the wall",
       [] {
         static_cast<void>(effective_wall_width(HitOnWall{.contact_width = 3 * m, .height = 2 * m, .width = 2 * m}));
       },
       {"effective_wall_width", "contact_width", "3 m", "> 0 m and <= width = 2 m", "Check its sign and its unit"}},
      {"an approach at rest",
       [] { static_cast<void>(linear_stiffness(hertz, {.mass = 1 * kg, .speed = 0 * m / s})); },
       {"linear_stiffness", "speed", "0 m/s", "> 0 m/s and finite",
        "The equivalent of a Hertz stiffness depends on the speed;"}},
      {"a spring in series with nothing",
       [approach] { static_cast<void>(in_series(hertz, 0 * N / m, approach)); },
       {"in_series", "behind", "0 N/m", "> 0 N/m and finite", "Check its sign and its unit"}},
      {"a free impact of no mass",
       [] {
         static_cast<void>(delivered_restitution(FreeImpact{.force = [](double d, double) { return d; },
                                                            .margin = [](double d, double) { return d; },
                                                            .goes_on = [](double, double) { return false; },
                                                            .effective_mass = 0.0,
                                                            .approach_speed = 1.0,
                                                            .duration = 1.0}));
       },
       {"FreeImpact", "effective_mass", "0 kg", "> 0 kg", "1/m = 1/m_1 + 1/m_2"}},
  };
}

}  // namespace moat::constructions
