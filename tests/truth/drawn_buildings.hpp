// Buildings drawn at random, and other views of one.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "outcome.hpp"
#include "random_cases.hpp"

namespace moat::testing {

/// How a building is drawn: its numbers come from the seed.
struct Draw {
  std::uint64_t seed = 0;
  int storeys = 1;        ///< 1 to 6; a tower in plan has its own number
  bool walls = true;      ///< beside its base
  double duration = 8.0;  ///< s, of the motion
};
inline std::ostream& operator<<(std::ostream& out, const Draw& draw) {
  return out << "seed " << draw.seed << ", storeys " << draw.storeys << (draw.walls ? ", walls" : ", no walls") << ", "
             << draw.duration << " s";
}

/// Smaller ones have one storey less, no walls, and half of the motion.
rc::Gen<Draw> draws();

/// The way in which one building is described.
struct View {
  bool mirrored = false;  ///< left and right are exchanged, the motion has the other sign; not in plan
  Angle turn{};           ///< in plan
  double mass = 1.0;      ///< factor of masses, stiffnesses and forces
  bool reversed = false;  ///< isolators, and columns in plan, are added in the opposite order
};

using DrawnBuilding = Problem (*)(const Draw&, const View&);

/// Shear buildings on every law of isolators, dampers and storeys, some beside lead-rubber bearings.
Problem building_on_any_law(const Draw& draw, const View& view = {});
/// Its law is one without constants of measured units, which do not scale.
Problem building_on_a_scalable_law(const Draw& draw, const View& view = {});
/// On two unequal bearings of a scalable law whose axial force follows overturning and, in some, a vertical motion.
Problem building_that_overturns(const Draw& draw, const View& view = {});
/// Given by a stiffness matrix of shear and bending, with damping ratios of its modes.
Problem building_of_a_matrix(const Draw& draw, const View& view = {});
/// A plane frame of beams and columns.
Problem building_of_a_frame(const Draw& draw, const View& view = {});
/// random_tower(), on every law of two components; some with axial forces.
Problem tower_in_plan(const Draw& draw, const View& view = {});

/// A kind of buildings, for tests of every kind.
struct Family {
  const char* name;
  DrawnBuilding building;

  friend void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }
};
inline constexpr Family families[]{{"AnyLaw", building_on_any_law},
                                   {"Overturning", building_that_overturns},
                                   {"Matrix", building_of_a_matrix},
                                   {"Frame", building_of_a_frame},
                                   {"Plan", tower_in_plan}};
inline auto name_of_family = [](const auto& tested) { return std::string{tested.param.name}; };

}  // namespace moat::testing
