// Tour 14: a small frame, without another program. Read 13_from_matrices.cpp before.
//
// Three storeys and two bays of steel. moat condenses the frame to the horizontal motions of its three floors:
// 15 members become a matrix of 3 x 3. The nodes of a level move together; feet are clamped to the base.
//
//     3  o----o----o      A Frame gives the motions of floors. Forces in its members are the business of the program
//        |    |    |      with which the building was designed.
//     2  o----o----o
//        |    |    |
//     1  o----o----o
//        |    |    |
//        =  base   =
//
//     ./moat run examples/14_frame.cpp
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "A frame of three storeys"};
  const Length gap = script.length("gap", 18 * cm, "clearance on each side");
  const ElasticMaterial steel{.E = 206 * GPa, .poisson = 0.3};
  const MemberSection column{.area = 0.02 * m_2, .I_y = 8e-4 * m_4, .I_z = 8e-4 * m_4},
      beam{.area = 0.015 * m_2, .I_y = 4.5e-4 * m_4, .I_z = 4.5e-4 * m_4};

  // Nodes 10 level + line: 0 to 2 are the feet, 30 to 32 the roof.
  Frame frame{.name = "frame", .motion = LevelMotion::along_x};
  for (int level = 0; level <= 3; ++level)
    for (int line = 0; line <= 2; ++line) {
      const int node = 10 * level + line;
      frame.nodes.push_back({.name = node, .x = 6.0 * line * m, .z = 3.6 * level * m});
      if (level > 0) frame.members.push_back({.from = node - 10, .to = node, .section = column, .material = steel});
      if (level > 0 && line > 0)
        frame.members.push_back({.from = node - 1, .to = node, .section = beam, .material = steel});
    }
  for (int level = 1; level <= 3; ++level)
    frame.levels.push_back({.height = 3.6 * level * m, .mass = (level == 3 ? 40 : 50) * tonne});

  Model model;
  const auto building = add(model, Superstructure{.condensed = frame.condensed(),
                                                  .damping = ModalDamping{0.02},
                                                  .base = SuperstructureBase{.mass = 55 * tonne},
                                                  .isolation = LeadRubberBearing{.yield_force = 110 * kN,
                                                                                 .yield_displacement = 1 * cm,
                                                                                 .post_yield_stiffness = 1 * MN / m}});
  add(model, Moat{.around = building.base,
                  .clearance = gap,
                  .law = ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65}});

  return script.run(model, script.motion(near_fault_pulse({.pulse_period = 1.2 * s})).scaled_to_pga(0.3 * g));
}
