// The building of section 4.2 of Zhao, Liu & Li (2017), in the plain reading of its numbers.
//
// The paper's text contradicts itself in places. The plain reading takes the values that give the periods of the paper:
//   - post-yield stiffness of the bearings 1.93e7 N/m (printed 1.93e6, but the stated 2.5 s of 3.05e6 kg need ten
//     times that), yield force 1.93e6 N (printed "1.93e6 kN"), yield displacement 1 cm;
//   - linear storeys: their printed post-yield stiffness comes without a yield force;
//   - Rayleigh damping of 5 % in the first two modes of the superstructure on its base;
//   - Eq. 33 with the mass of all floors (the printed sum ends at the third).
#pragma once

#include <moat.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace moat::paper {

using namespace units;

struct PaperBuilding {
  int storeys = 5;
  double damping_ratio = 0.05;  ///< of the superstructure
  Force yield_force = 1.93 * MN;
  Length yield_displacement = 1 * cm;
  Stiffness post_yield_stiffness = 19.3 * MN / m;
  /// A dashpot beside the bearings, which the paper does not have: N s/m.
  DampingCoefficient isolator_damping{};
  bool isolated = true;
};

inline constexpr Mass floor_mass = 500 * tonne;
inline constexpr Mass base_mass = 550 * tonne;
inline constexpr Length paper_gap = 10 * cm;
inline constexpr Stiffness linear_impact_stiffness = 5.8e8 * N / m;
inline constexpr HertzStiffness hertz_impact_stiffness = 2.95e9 * N / m_3_2;
inline constexpr double restitution = 0.65;

/// Mass of base and floors.
inline Mass total_mass(int storeys) { return base_mass + storeys * floor_mass; }

/// The inverse of Eq. 33: the post-yield stiffness that gives the isolation period T_b.
inline Stiffness stiffness_for_period(Time period, int storeys) {
  const Frequency w = 2.0 * std::numbers::pi / period;
  return total_mass(storeys) * w * w;
}

/// The inverse of Eq. 34: a dashpot of this damping ratio at the isolation period T_b.
inline DampingCoefficient isolator_damping(double ratio, Time period, int storeys) {
  return 2.0 * ratio * total_mass(storeys) * (2.0 * std::numbers::pi / period);
}

inline Building add(Model& model, const PaperBuilding& paper) {
  ShearBuilding building{.storeys = paper.storeys,
                         .floor_mass = floor_mass,
                         .storey_stiffness = 1 * GN / m,
                         .damping = {.ratio = paper.damping_ratio}};
  if (paper.isolated) {
    building.base_mass = base_mass;
    building.isolation = LeadRubberBearing{.yield_force = paper.yield_force,
                                           .yield_displacement = paper.yield_displacement,
                                           .post_yield_stiffness = paper.post_yield_stiffness};
  }
  Building nodes = moat::add(model, building);
  if (paper.isolator_damping > DampingCoefficient{})
    moat::add(model,
              ViscousDamper{
                  .name = "isolator damping", .lower = ground, .upper = nodes.base, .damping = paper.isolator_damping});
  return nodes;
}

/// The law of the parametric studies: "the modified Hertz-damp model is employed", e = 0.65.
inline ModifiedHertzDamp study_law(HertzStiffness stiffness = hertz_impact_stiffness) {
  return {.stiffness = stiffness, .restitution = restitution};
}

/// The building inside its walls with the law of the parametric studies.
inline Building add_pounding(Model& model, const PaperBuilding& building, Length gap = paper_gap,
                             HertzStiffness stiffness = hertz_impact_stiffness) {
  Building nodes = add(model, building);
  moat::add(model, Moat{.around = nodes.base, .clearance = gap, .law = study_law(stiffness)});
  return nodes;
}

}  // namespace moat::paper
