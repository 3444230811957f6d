// Frames of members, and finite-element models.
#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

// A cantilever of 3 m with a floor on it.
template <class Change>
std::function<void()> frame(Change change) {
  return [change] {
    Frame shed{.name = "shed",
               .nodes = {FrameNode{.name = 1}, FrameNode{.name = 2, .z = 3 * m}},
               .members = {FrameMember{.from = 1,
                                       .to = 2,
                                       .section = RectangularSection{.b = 0.5 * m, .h = 0.5 * m},
                                       .material = ElasticMaterial{.E = 30 * GPa}}},
               .levels = {FrameLevel{.height = 3 * m, .mass = 10 * tonne, .rotary_inertia = 10 * tonne * m_2}}};
    change(shed);
    static_cast<void>(shed.condensed());
  };
}
template <class Change>
std::function<void()> member(Change change) {
  return frame([change](Frame& shed) { change(shed.members[0]); });
}

}  // namespace

Constructions frames() {
  return {
      {"a section of no area",
       member([](auto& beam) { beam.section = MemberSection{.area = 0 * m_2}; }),
       {"Frame \"shed\"", "member 1 section.area", "0 m^2", "> 0 m^2 and finite", "Check its sign and its unit"}},
      {"a section that bends backwards",
       member([](auto& beam) { beam.section.I_y = -1.0 * m_4; }),
       {"Frame \"shed\"", "member 1 section.I_y", "-1 m^4", ">= 0 m^4 and finite", "Check its sign and its unit"}},
      {"a rectangle without width",
       member([](auto& beam) { beam.section = RectangularSection{.b = 0 * m, .h = 1 * m}; }),
       {"RectangularSection", "b", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"a material without stiffness",
       member([](auto& beam) { beam.material.E = 0 * Pa; }),
       {"Frame \"shed\"", "member 1 material.E", "0 Pa", "> 0 Pa and finite", "Check its sign and its unit"}},
      {"a material that grows sideways",
       member([](auto& beam) { beam.material.poisson = 0.6; }),
       {"Frame \"shed\"", "member 1 material.poisson", "0.6", "> -1 and <= 0.5", "Give a number in this range"}},
      {"a material of negative shear modulus",
       member([](auto& beam) { beam.material.G = -1 * Pa; }),
       {"Frame \"shed\"", "member 1 material.G", "-1 Pa", "> 0 Pa and finite", "Check its sign and its unit"}},
      {"a material lighter than nothing",
       member([](auto& beam) { beam.material.density = -1.0 * kg / m_3; }),
       {"Frame \"shed\"", "member 1 material.density", "-1 kg/m^3", ">= 0 kg/m^3 and finite",
        "Check its sign and its unit"}},
      {"a member to no node",
       member([](auto& beam) { beam.to = 3; }),
       {"Frame \"shed\"", "member 1", "there is no", "node 3", "Give it in .nodes"}},
      {"a member to its own node",
       member([](auto& beam) { beam.to = 1; }),
       {"Frame \"shed\"", "member 1", "nodes 1 and 1", "at the same place", "Give one of them another place"}},
      {"a member of offsets alone",
       member([](auto& beam) {
         beam.offset_from = RigidOffset{.z = 2 * m};
         beam.offset_to = RigidOffset{.z = -2 * m};
       }),
       {"Frame \"shed\"", "member 1: its offsets", "4 m", "3 m", "Offsets lead from its nodes inwards"}},
      {"a member that turns about itself",
       member([](auto& beam) { beam.releases_from = beam.releases_to = EndReleases{.rx = true}; }),
       {"Frame \"shed\"", "member 1", "all rotations about its axis", "are released", "Release rx at one end"}},
      {"a member with a reference along it",
       member([](auto& beam) {
         beam.reference = {0.0, 0.0, 2.0};
       }),
       {"Frame \"shed\"", "member 1: its reference", "direction", "is parallel to it",
        "Give a direction across the member"}},
      {"a frame without members",
       frame([](auto& shed) { shed.members.clear(); }),
       {"Frame \"shed\"", "has no", "members", "Give them", "in .members"}},
      {"a frame with a node twice",
       frame([](auto& shed) { shed.nodes[1].name = 1; }),
       {"Frame \"shed\"", "node", "1", "is given twice", "Give every node a name of its own"}},
      {"a frame without levels",
       frame([](auto& shed) { shed.levels.clear(); }),
       {"Frame \"shed\"", "has no", "levels", "Give", "the heights of its floors"}},
      {"a level in the air",
       frame([](auto& shed) { shed.levels[0].height = 5 * m; }),
       {"Frame \"shed\"", "floor 1", "height of 5 m", "the nearest node lies at 3 m", "Give the height of its nodes"}},
      {"a level without mass",
       frame([](auto& shed) { shed.levels[0].mass = -1 * kg; }),
       {"Frame \"shed\"", "floor 1 mass", "-1 kg", ">= 0 kg and finite", "Check its sign and its unit"}},
      {"a level with a node that is not there",
       frame([](auto& shed) { shed.levels[0] = FrameLevel{.nodes = {17}}; }),
       {"Frame \"shed\"", "there is no", "node 17", "Give it", "in .nodes"}},
      {"a frame that leans on nothing",
       frame([](auto& shed) { shed.nodes.push_back(FrameNode{.name = 3, .x = 1 * m, .z = 2 * m}); }),
       {"Frame \"shed\"", "node 3, x", "has no stiffness", "a pinned end", "a missing restraint"}},
      {"finite elements at no place",
       [] { static_cast<void>(condensed(FiniteElements{.nodes = {FrameNode{.x = not_a_number * m}}})); },
       {"FiniteElements", "a coordinate of node 1", "nan m", "a finite number", "division by zero"}},
      {"finite elements without nodes",
       [] { static_cast<void>(condensed(FiniteElements{})); },
       {"FiniteElements", "has no", "nodes", "Give them", "in .nodes"}},
      {"finite elements in no file",
       [] {
         static_cast<void>(read_sap2000("no such model", "no such joints.csv", MatrixUnits{.force = kN, .length = m}));
       },
       {"no such joints.csv", "there is", "no such file", "Check", "the path"}},
  };
}

}  // namespace moat::constructions
