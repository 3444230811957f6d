// Bearings of a building, their designs, geometry and checks.
#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

const RubberBearing rubber{
    .diameter = 0.7 * m, .layer_thickness = 6 * mm, .rubber_thickness = 0.15 * m, .shear_modulus = 0.4 * MPa};

template <class Change>
std::function<void()> rubber_bearing(Change change) {
  return [change] {
    RubberBearing bearing = rubber;
    change(bearing);
    bearing.check(Check{"RubberBearing", "LRB700"});
  };
}
template <class Change>
std::function<void()> design(Change change) {
  return [change] {
    BearingDesign bearing{
        .weight = 10 * MN, .strength_ratio = 0.06, .isolation_period = 3 * s, .yield_displacement = 15 * mm};
    change(bearing);
    static_cast<void>(LeadRubberBearing::from_design(bearing));
  };
}
template <class Change>
std::function<void()> isolator(Change change) {
  return [change] {
    Model model;
    Isolator<SofteningRubber> bearing{
        .upper = add(model, Node{.name = "base", .mass = 100 * tonne}),
        .law = {.bearing =
                    Bilinear{.yield_force = 0.1 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1 * MN / m},
                .rubber = rubber},
        .weight = 1 * MN};
    change(bearing);
    add(model, bearing);
  };
}

}  // namespace

Constructions bearings() {
  return {
      {"design without strength",
       design([](auto& d) { d.strength_ratio = 0; }),
       {"LeadRubberBearing::from_design", "characteristic_strength and strength_ratio", "both given, or neither",
        "Give one", "of them"}},
      {"design stronger than its weight",
       design([](auto& d) { d.strength_ratio = 6; }),
       {"LeadRubberBearing::from_design", "strength_ratio", "6", "> 0 and < 1", "6 % of the weight is 0.06"}},
      {"design without weight",
       design([](auto& d) { d.weight = 0 * N; }),
       {"LeadRubberBearing::from_design", "weight", "0 N", "> 0 N and finite",
        "Give the weight that the bearings carry, m g"}},
      {"design of no period",
       design([](auto& d) { d.isolation_period = 0 * s; }),
       {"LeadRubberBearing::from_design", "isolation_period", "0 s", "> 0 s and finite",
        "Check its sign and its unit"}},
      {"lead-rubber bearing under nothing",
       [] {
         Model model;
         add(model, LeadRubberBearing{
                        .yield_force = 1 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1 * MN / m});
       },
       {"LeadRubberBearing \"bearings\"", "upper", "is not given", "Set it to", "a node of this model"}},
      {"no bearing side by side",
       isolator([](auto& i) { i.count = 0; }),
       {"Isolator \"bearings\"", "count", "0", ">= 1", "Give a number in this range"}},
      {"softening rubber without weight",
       isolator([](auto& i) { i.weight = 0 * N; }),
       {"Isolator \"bearings\"", "weight", "0 N", "> 0 N and finite",
        "Give the weight that it carries; a ShearBuilding knows its"}},
      {"softening rubber without rubber",
       isolator([](auto& i) { i.law.rubber.rubber_thickness = 0 * m; }),
       {"Isolator \"bearings\"", "rubber_thickness", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"rubber round and rectangular",
       rubber_bearing([](auto& r) { r.width_x = 1 * m; }),
       {"RubberBearing \"LRB700\"", "diameter and widths", "both given", "or neither",
        "Give diameter, or width_x and width_y"}},
      {"rubber as a plank",
       rubber_bearing([](auto& r) {
         r.diameter = 0 * m;
         r.width_x = 1 * m;
         r.width_y = 0.3 * m;
       }),
       {"RubberBearing \"LRB700\"", "ratio of widths", "3.33333", "<= 2",
        "The formulas of the rubber are those of a square"}},
      {"rubber that is a fluid",
       rubber_bearing([](auto& r) { r.shear_modulus = 0 * Pa; }),
       {"RubberBearing \"LRB700\"", "shear_modulus", "0 Pa", "> 0 Pa and finite", "Check its sign and its unit"}},
      {"a slider of no area",
       [] {
         BearingCapacities{.slider_area = 0 * m_2}.check(Check{"BearingCapacities", "slider"});
       },
       {"BearingCapacities \"slider\"", "slider_area", "0 m^2", "> 0 m^2 and finite",
        "Leave it out where it is not known"}},
      {"a bearing that creeps backwards",
       [] {
         BearingCapacities{.static_displacement = -1 * cm}.check(Check{"BearingCapacities", "slider"});
       },
       {"BearingCapacities \"slider\"", "static_displacement", "-0.01 m", ">= 0 m and finite",
        "Check its sign and its unit"}},
      {"capacities of a bearing that is not there",
       [] {
         Model model;
         add(model, Node{.name = "body", .mass = 1 * kg, .free = true});
         BearingCheckRecorder checks{CheckRules::none, {{"bearnigs", {.stroke = 1 * m}}}};
         CaseRun run{model, still_ground(1 * s)};
         run.attach(checks);
         run.run();
       },
       {"BearingCheckRecorder", "bearnigs", "no element has this", "name or type", "Give the name of a bearing"}},
      {"isolators that do not come back",
       [] {
         static_cast<void>(restoring_checks(
             Backbone{.strength = 1 * MN, .restoring_stiffness = 0 * N / m, .weight = 10 * MN}, 0.3 * m));
       },
       {"restoring_checks", "restoring_stiffness", "0 N/m", "> 0 N/m and finite",
        "Isolators without one do not come back"}},
      {"isolators that stay at rest",
       [] {
         static_cast<void>(restoring_checks(
             Backbone{.strength = 1 * MN, .restoring_stiffness = 1 * MN / m, .weight = 10 * MN}, 0 * m));
       },
       {"restoring_checks", "displacement", "0 m", "> 0 m and finite", "Give the design displacement"}},
  };
}

}  // namespace moat::constructions
