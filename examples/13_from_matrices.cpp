// Tour 13: a building from the matrix of a finite-element program. Read 01_moat_wall.cpp before.
//
// A frame bends: shear springs between its floors have its first period, and miss the others by 6 to 25 %. Its
// stiffness, condensed to the twelve floors, has them all. The file is a table of 12 x 12 numbers in kN/m; how SAP2000,
// ETABS and OpenSees write one stands in docs/explanation/coming_from.md. Damping is 5 % in every mode.
//
//     ./moat run examples/13_from_matrices.cpp
//     ./moat run examples/13_from_matrices.cpp --gap "30 cm" --out results/wider
#include <moat.hpp>

#include <filesystem>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "A frame from its stiffness matrix"};
  const Length gap = script.length("gap", 25 * cm, "clearance on each side");
  const std::filesystem::path data = std::filesystem::path{__FILE__}.parent_path() / "data";

  std::vector<SuperstructureFloor> floors;
  for (int floor = 1; floor <= 12; ++floor)
    floors.push_back({.height = (4.5 + 3.5 * (floor - 1)) * m, .mass = (floor == 12 ? 50 : 60) * tonne});

  Model model;
  const auto frame =
      add(model, Superstructure{.stiffness = read_matrix(data / "frame_stiffness.csv", {.force = kN, .length = m}),
                                .freedoms = per_floor(Freedoms::x),
                                .floors = floors,
                                .damping = ModalDamping{0.05},
                                .base = SuperstructureBase{.mass = 80 * tonne},
                                .isolation = LeadRubberBearing{.yield_force = 500 * kN,
                                                               .yield_displacement = 10 * mm,
                                                               .post_yield_stiffness = 3.4 * MN / m}});
  add(model, Moat{.around = frame.base, .clearance = gap, .law = LinearElastic{.stiffness = 200 * MN / m}});

  return script.run(model, script.motion(near_fault_pulse({.pulse_period = 2.5 * s})).scaled_to_pga(0.25 * g));
}
