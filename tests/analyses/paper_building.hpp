// The building of Zhao, Liu & Li (2017).
#pragma once

#include "moat.hpp"
#include "unlocated_bilinear.hpp"

namespace moat::testing {

inline constexpr double floor_mass = 5e5, base_mass = 5.5e5, storey_stiffness = 1e9;
inline constexpr double yield_force = 1.93e6, yield_displacement = 0.01, post_yield_stiffness = 1.93e7;

inline LeadRubberBearing paper_bearings() {
  using namespace units;
  return {.yield_force = yield_force * N,
          .yield_displacement = yield_displacement * m,
          .post_yield_stiffness = post_yield_stiffness * N / m};
}

/// The same bearings as a law of a script, whose yields are not located.
inline UnlocatedBilinear unlocated_paper_bearings() { return {yield_force, yield_displacement, post_yield_stiffness}; }

inline ShearBuilding paper_building(std::string name = {}) {
  using namespace units;
  return {.name = std::move(name),
          .storeys = 5,
          .floor_mass = floor_mass * kg,
          .storey_stiffness = storey_stiffness * N / m,
          .damping = RayleighDamping{.ratio = 0.05},
          .base_mass = base_mass * kg,
          .isolation = paper_bearings()};
}

inline ShearBuilding paper_building_on_fixed_base() {
  ShearBuilding building = paper_building();
  building.base_mass = {};
  building.isolation.reset();
  return building;
}

inline HertzDamp paper_hertz_damp() { return {.stiffness = 2.95e9 * units::N / units::m_3_2, .restitution = 0.65}; }

/// A building on bearings inside a moat with the contacts of the paper.
inline Model pounding_building(Length clearance = 10 * units::cm, const ShearBuilding& building = paper_building()) {
  Model model;
  add(model, Moat{.around = add(model, building).base, .clearance = clearance, .law = paper_hertz_damp()});
  return model;
}

}  // namespace moat::testing
