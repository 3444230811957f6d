// Names are unique among nodes and among elements, but an element may have the name of a node: no picture and no table
// may take one for the other.

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>

#include "moat.hpp"
#include "report/charts/result_charts.hpp"
#include "report/sections.hpp"
#include "report_testing.hpp"
#include "small_models.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;
using Naming = std::function<std::string(const std::string&)>;

const GroundMotion& pulse() {
  static const GroundMotion motion = near_fault_pulse({.pulse_period = 1.3 * s}).scaled_to_pga(0.4 * g);
  return motion;
}

// The same numbers in the same order, where names of elements go through `naming`.
void expect_equal_but_for_names(const CaseResult& plain, const CaseResult& renamed, const Naming& naming) {
  ASSERT_EQ(plain.peaks.size(), renamed.peaks.size());
  for (std::size_t i = 0; i < plain.peaks.size(); ++i) {
    const Peak &a = plain.peaks[i], &b = renamed.peaks[i];
    EXPECT_EQ(naming(a.where), b.where);
    EXPECT_EQ(a.value, b.value) << a.quantity << " of " << b.where;
    EXPECT_EQ(naming(a.side), b.side) << a.quantity << " of " << b.where;
  }
  const ResultCharts charts = result_charts(plain), others = result_charts(renamed);
  ASSERT_EQ(charts.all().size(), others.all().size());
  for (std::size_t i = 0; i < charts.all().size(); ++i) {
    const Chart &a = *charts.all()[i], &b = *others.all()[i];
    SCOPED_TRACE(a.title);
    ASSERT_EQ(a.series.size(), b.series.size());
    for (std::size_t k = 0; k < a.series.size(); ++k) {
      EXPECT_EQ(naming(a.series[k].name), b.series[k].name);
      EXPECT_EQ(a.series[k].x, b.series[k].x);
      EXPECT_EQ(a.series[k].y, b.series[k].y);
    }
  }
}

// Two towers side by side whose elements have these names.
CaseResult towers(const Naming& naming) {
  Model model;
  const auto tower = [&](const std::string& name, Mass mass) {
    Building building{.name = name, .base = add(model, Node{.name = name + " base", .mass = mass})};
    add(model, LeadRubberBearing{.name = naming(name + " bearings"),
                                 .upper = building.base,
                                 .yield_force = 0.5 * MN,
                                 .yield_displacement = 1 * cm,
                                 .post_yield_stiffness = 4 * MN / m});
    for (int i = 1; i <= 3; ++i) {
      const std::string number = std::to_string(i);
      const NodeId floor =
          add(model, Node{.name = name + " floor " + number, .mass = mass, .height = 3.5 * static_cast<double>(i) * m});
      add(model, ShearSpring{.name = naming(name + " storey " + number),
                             .lower = building.top(),
                             .upper = floor,
                             .stiffness = 0.3 * GN / m});
      building.floors.push_back(floor);
    }
    add(model, building);
    return building;
  };
  const Building a = tower("a", 200 * tonne), b = tower("b", 300 * tonne);
  for (int i = 1; i <= 3; ++i)
    add(model, Gap{.name = naming("gap " + std::to_string(i)),
                   .left = MemberPoint{a.floor(i), i == 1 ? a.base : a.floor(i - 1), 0.4},
                   .right = b.floor(i),
                   .clearance = 2 * cm,
                   .law = HertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65}});
  return run_case(model, pulse(), {.transient = {.end = 4 * s}});
}

Naming by(const std::map<std::string, std::string>& names) {
  return [names](const std::string& name) { return names.contains(name) ? names.at(name) : name; };
}

TEST(NamesOfPlaces, ElementsMayHaveNamesOfFloors) {
  const CaseResult plain = towers([](const std::string& name) { return name; });
  ASSERT_FALSE(plain.impacts.empty());
  for (const auto& names : {std::map<std::string, std::string>{{"gap 1", "b floor 1"}, {"gap 2", "b floor 2"}},
                            {{"gap 1", "a floor 3"}, {"gap 2", "a base"}, {"gap 3", "b base"}},
                            {{"a storey 1", "a floor 2"}, {"a storey 2", "b floor 3"}, {"b storey 3", "b base"}},
                            {{"a bearings", "b floor 1"}, {"b bearings", "a base"}}})
    expect_equal_but_for_names(plain, towers(by(names)), by(names));
}

// A tower in plan whose walls and springs have these names.
CaseResult tower_in_plan(const Naming& naming) {
  Model model;
  const PlanOutline outline = rectangle(20 * m, 12 * m);
  std::vector<DiaphragmId> floors;
  for (const char* name : {"base", "base 2"})
    floors.push_back(add(model, Diaphragm{.name = name,
                                          .mass = 400 * tonne,
                                          .centre_of_mass = {1 * m, 0.5 * m},
                                          .outline = outline,
                                          .height = 3.5 * static_cast<double>(floors.size()) * m}));
  for (std::size_t i = 0; i < 2; ++i)
    for (const PlanPosition& at : outline.corners)
      add(model, PlanarSpring<BiaxialBilinear>{
                     .name = naming((i == 0 ? "bearing " : "column ") + to_text(at.x.si()) + to_text(at.y.si())),
                     .lower = PlanPoint{i == 0 ? ground : floors[0].x, at},
                     .upper = PlanPoint{floors[i], at},
                     .law = BiaxialBilinear{.yield_force = i == 0 ? 0.1 * MN : 10 * MN,
                                            .yield_displacement = 1 * cm,
                                            .post_yield_stiffness = 1 * MN / m},
                     .isolates = i == 0});
  add(model, Building{.base = floors[0], .floors = {floors[1]}});
  for (std::size_t i = 0; i < 2; ++i)
    add(model, CornerGap<HertzDamp>{.name = naming("gap " + std::to_string(i + 1)),
                                    .corner = PlanPoint{floors[i], {10 * m, 6 * m}},
                                    .edge_of = ground,
                                    .edge_begin = PlanPosition{10.03 * m, -10 * m},
                                    .edge_end = PlanPosition{10.03 * m, 10 * m},
                                    .law = {.stiffness = 1e9 * N / m_3_2, .restitution = 0.65},
                                    .corner_name = i == 0 ? "base corner 3" : "base 2 corner 3"});
  return run_case(model, pulse(), {.transient = {.end = 3 * s}});
}

TEST(NamesOfPlaces, ElementsInPlanMayHaveNamesOfFloors) {
  const CaseResult plain = tower_in_plan([](const std::string& name) { return name; });
  ASSERT_FALSE(plain.impacts.empty());
  const Naming naming = by({{"gap 1", "base 2"}, {"gap 2", "base"}, {"bearing 106", "base:x"}});
  const CaseResult renamed = tower_in_plan(naming);
  expect_equal_but_for_names(plain, renamed, naming);
}

TEST(NamesOfPlaces, WallsOfOneNameAreAllDrawn) {
  Model model;
  const DiaphragmId slab = add(
      model,
      Diaphragm{
          .name = "slab", .mass = 100 * tonne, .outline = rectangle(20 * m, 12 * m), .initial_velocity_x = 1 * m / s});
  const auto add_gap = [&](const std::string& name, PlanPosition begin, PlanPosition end) {
    add(model, CornerGap<Hertz>{.name = name,
                                .corner = PlanPoint{slab, {10 * m, 6 * m}},
                                .edge_of = ground,
                                .edge_begin = begin,
                                .edge_end = end,
                                .law = {.stiffness = 1e9 * N / m_3_2}});
  };
  add_gap("east", {10.1 * m, -8 * m}, {10.1 * m, 8 * m});
  add_gap("north", {12 * m, 6.1 * m}, {-12 * m, 6.1 * m});
  const CaseResult result = run_case(model, testing::still_ground(0.2 * s));
  EXPECT_EQ(testing_report::count(html::drawing_section(result), "class=\"wall\""), 2U);
}

TEST(NamesOfPlaces, ANodeAndADiaphragmDoNotShareAName) {
  Model model;
  add(model, Diaphragm{.name = "tower", .mass = 1 * tonne, .size = {1 * m, 1 * m}});
  EXPECT_THROW(add(model, Node{.name = "tower", .mass = 1 * tonne, .direction = PlanVector{1.0, 0.0}}), InputError);
  add(model, Node{.name = "wall", .mass = 1 * tonne, .direction = PlanVector{1.0, 0.0}});
  EXPECT_THROW(add(model, Diaphragm{.name = "wall", .mass = 1 * tonne, .size = {1 * m, 1 * m}}), InputError);
}

}  // namespace
}  // namespace moat
