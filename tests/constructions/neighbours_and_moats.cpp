// Buildings beside each other, and walls around them.
#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

const Hertz law{.stiffness = 1e9 * N / m_3_2};

template <class Change>
std::function<void()> line_moat(Change change) {
  return [change] {
    Model model;
    Moat<Hertz> walls{.around = add(model, Node{.name = "base", .mass = 1 * tonne}), .clearance = 10 * cm, .law = law};
    change(walls);
    add(model, walls);
  };
}
std::function<void()> flexible(const FlexibleWall& wall) {
  return line_moat([wall](Moat<Hertz>& walls) { walls.wall = wall; });
}
std::function<void()> cantilever(const WallGeometry& geometry) {
  return [geometry] { static_cast<void>(FlexibleWall::from_geometry(geometry)); };
}
template <class Change>
std::function<void()> plan_moat(Change change) {
  return [change] {
    Model model;
    PlanMoat<Hertz> walls{
        .around = add(model, Diaphragm{.name = "base", .mass = 100 * tonne, .outline = rectangle(20 * m, 12 * m)}),
        .clearance = 10 * cm,
        .law = law};
    change(walls);
    add(model, walls);
  };
}
template <class Change>
std::function<void()> neighbours(Change change) {
  return [change] {
    Model model;
    ShearBuilding house{.name = "left", .storeys = 2, .floor_mass = 1 * tonne, .storey_stiffness = 1 * MN / m};
    house.storey_height = 3 * m;
    const Building left = add(model, house);
    house.name = "right";
    Neighbours joint{.name = "joint", .left = left, .right = add(model, house), .clearance = 10 * cm, .law = law};
    change(joint);
    add(model, joint);
  };
}
template <class Change>
std::function<void()> plan_neighbours(Change change, Length distance = 21 * m) {
  return [change, distance] {
    Model model;
    const DiaphragmId first =
        add(model, Diaphragm{.name = "first", .mass = 1 * tonne, .outline = rectangle(20 * m, 12 * m)});
    const DiaphragmId second = add(model, Diaphragm{.name = "second",
                                                    .mass = 1 * tonne,
                                                    .centre_of_mass = {distance, 0 * m},
                                                    .outline = rectangle(20 * m, 12 * m, {distance, 0 * m})});
    PlanNeighbours joint{.name = "joint", .first = first, .second = second, .law = law, .reach = 2 * m};
    change(joint);
    add(model, joint);
  };
}
constexpr auto as_it_is = [](auto&) {};

}  // namespace

Constructions neighbours_and_moats() {
  const FlexibleWall soft{.mass = 1 * tonne, .stiffness = 1 * MN / m};
  const auto wall = [soft](auto change) {
    FlexibleWall changed = soft;
    change(changed);
    return flexible(changed);
  };
  const WallGeometry concrete{.height = 3 * m, .thickness = 0.3 * m, .width = 5 * m, .youngs_modulus = 30 * GPa};
  const auto built = [concrete](auto change) {
    WallGeometry changed = concrete;
    change(changed);
    return cantilever(changed);
  };
  return {
      {"a moat inside the building",
       line_moat([](auto& walls) { walls.clearance = -5 * cm; }),
       {"Gap \"moat left\"", "clearance", "-0.05 m", ">= 0 m and finite",
        "Give the free distance at rest, 0 m for wall to wall; a"}},
      {"a moat around the ground",
       line_moat([](auto& walls) { walls.around = ground; }),
       {"Gap \"moat left\"", "left and right", "\"ground\"", "An element joins", "two different nodes"}},
      {"a moat without name",
       line_moat([](auto& walls) { walls.name = ""; }),
       {"Moat", "a moat", "has no name", "Give .name", "\"moat\""}},
      {"a wall of negative stiffness",
       wall([](auto& w) { w.stiffness = -1 * N / m; }),
       {"FlexibleWall \"moat left wall\"", "stiffness", "-1 N/m", "> 0 N/m and finite", "Check its sign and its unit"}},
      {"a wall of two laws",
       wall([](auto& w) { w.law = Linear{.stiffness = 1 * MN / m}; }),
       {"FlexibleWall \"moat left wall\"", "stiffness", "1e+06 N/m", "left out where law is given",
        "Give one of both"}},
      {"a wall that hardens as it was",
       wall([](auto& w) { w.hardening_ratio = 1; }),
       {"FlexibleWall \"moat left wall\"", "hardening_ratio", "1", ">= 0 and < 1", "Give a number in this range"}},
      {"a wall without mass",
       wall([](auto& w) { w.mass = 0 * kg; }),
       {"FlexibleWall \"moat left wall\"", "mass", "0 kg", "> 0 kg and finite", "Check its sign and its unit"}},
      {"a wall that drives",
       wall([](auto& w) { w.damping = -1 * N * s / m; }),
       {"FlexibleWall \"moat left wall\"", "damping", "-1 N s/m", ">= 0 N s/m and finite",
        "Check its sign and its unit"}},
      {"a wall as thick as nothing",
       built([](auto& w) { w.thickness = 0 * m; }),
       {"WallGeometry", "thickness", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"a wall without cracks to the last",
       built([](auto& w) { w.cracked_share = 1.5; }),
       {"WallGeometry", "cracked_share", "1.5", "> 0 and <= 1", "0.3 to 0.5 where concrete has cracked"}},
      {"a wall that turns backwards",
       built([](auto& w) { w.base_rotation = -1 * J; }),
       {"WallGeometry", "base_rotation", "-1 N m", ">= 0 N m and finite", "Check its sign and its unit"}},
      {"a moat in plan out of reach",
       plan_moat([](auto& walls) { walls.clearance = 2 * m; }),
       {"PlanMoat \"moat\"", "clearance", "2 m", "at most the reach, 1 m",
        "No corner would meet a wall: give a longer .reach"}},
      {"a moat in plan without walls",
       plan_moat([](auto& walls) { walls.clearance.reset(); }),
       {"PlanMoat \"moat\"", "clearance", "is not given", "free distance at rest", "or .walls"}},
      {"a moat in plan with walls and clearance",
       plan_moat([](auto& walls) { walls.walls = rectangle(30 * m, 20 * m); }),
       {"PlanMoat \"moat\"", "both", ".clearance and .walls", "are given", "Leave one of them out"}},
      {"a moat in plan whose walls cross the base",
       plan_moat([](auto& walls) {
         walls.clearance.reset();
         walls.walls = rectangle(19 * m, 20 * m);
       }),
       {"PlanMoat \"moat\"", "overlap at rest", "(-10, -6) m", "inside the walls", "Give walls around the outline"}},
      {"a moat in plan with two points on a face",
       plan_moat([](auto& walls) { walls.points_per_face = 2; }),
       {"PlanMoat \"moat\"", "points_per_face", "2", "0, or >= 3",
        "Two points of a face are its corners: give .share ="}},
      {"a moat in plan with soil",
       plan_moat([](auto& walls) {
         walls.wall = FlexibleWall{.mass = 1 * tonne, .stiffness = 1 * MN / m};
         walls.wall->backfill = HyperbolicBackfill{.initial_stiffness = 20 * MN / m, .ultimate_force = 300 * kN};
       }),
       {"FlexibleWall \"moat wall 1\"", "backfill", "is given", "walls in plan do not have", "Leave it out"}},
      {"neighbours with slabs of negative thickness",
       neighbours([](auto& joint) { joint.slab = -1 * cm; }),
       {"Neighbours \"joint\"", "slab", "-0.01 m", ">= 0 m and finite",
        "Give the thickness of slabs: levels within it meet each"}},
      {"neighbours with facades that fall",
       neighbours([](auto& joint) {
         joint.clearance = {ClearanceAt{6 * m, 10 * cm}, ClearanceAt{3 * m, 10 * cm}};
       }),
       {"Neighbours \"joint\"", "clearance", "heights must rise", "6 m, 3 m", "Give the list from the lowest up"}},
      {"neighbours with facades that end below the roof",
       neighbours([](auto& joint) {
         joint.clearance = {ClearanceAt{0 * m, 10 * cm}, ClearanceAt{4 * m, 10 * cm}};
       }),
       {"Neighbours \"joint\"", "clearance", "from 0 to 4 m", "a gap is at 6 m",
        "Give entries below and above all gaps"}},
      {"neighbours that overlap",
       neighbours([](auto& joint) { joint.clearance = -1 * cm; }),
       {"Gap \"joint", "left floor 1 - right floor 1 at 3.00 m\": clearance", "-0.01 m", ">= 0 m and finite",
        "Give the free distance at rest, 0 m for wall to wall; a"}},
      {"a neighbour of itself",
       neighbours([](auto& joint) { joint.right = joint.left; }),
       {"Neighbours \"joint\"", "\"left\" and \"left\"", "a common floor", "Give", "two buildings"}},
      {"neighbours in plan that overlap",
       plan_neighbours(as_it_is, 19 * m),
       {"PlanNeighbours \"joint\"", "overlap at rest", "outlines", "Move one of them away",
        "until they touch at most"}},
      {"neighbours in plan too far apart",
       plan_neighbours(as_it_is, 30 * m),
       {"PlanNeighbours \"joint\"", "no corner", "reach", "Give a longer .reach", "2 m"}},
      {"neighbours in plan that stick",
       plan_neighbours([](auto& joint) { joint.friction = -0.1; }),
       {"CornerGap \"joint first corner 2 second edge 4\"", "friction", "-0.1", "from 0 to 1",
        "Concrete on concrete has 0.4 to 0.6, steel 0.2 to 0.3"}},
      {"neighbours in plan that reach back",
       plan_neighbours([](auto& joint) { joint.reach = -1 * m; }),
       {"PlanNeighbours \"joint\"", "reach", "-1 m", "> 0 m and finite", "Check its sign and its unit"}},
  };
}

}  // namespace moat::constructions
