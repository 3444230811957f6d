// A building that shears: rigid floors, one spring per storey, isolated or fixed at its base.
#pragma once

#include <optional>
#include <string>

#include "model/model.hpp"
#include "structures/isolation.hpp"
#include "structures/per_storey.hpp"
#include "structures/rayleigh_damping.hpp"
#include "structures/storey_law.hpp"

namespace moat {

/// A shear building on isolators, or fixed to the ground.
///
///     [ floor 3 ]     floor_mass
///        | |          storey_stiffness, storey_height, Rayleigh damping
///        ...
///     [ floor 1 ]
///        | |
///     [  base   ]     base_mass                (none without isolation: the ground is the base)
///     =========       isolation
///
/// Masses, stiffnesses and heights are one value for all storeys or one for each (structures/per_storey.hpp). Rayleigh
/// damping has its ratio in the first two modes of this chain held at its base, and acts on the motion of the
/// superstructure relative to its base. The stiffness part is a dashpot in every storey, the mass part a dashpot from
/// every floor to the base, reacting on it.
struct ShearBuilding {
  /// Put before the names of all parts ("north base", "north floor 1") where a model has several buildings.
  std::string name{};
  /// >= 1.
  Required<int> storeys;
  /// > 0 kg, each floor above the base.
  PerStorey<Mass> floor_mass;
  /// > 0 N/m, each storey; left out where `storey` is given.
  PerStorey<Stiffness> storey_stiffness = Stiffness{};
  /// Storeys with a law of their own: YieldingStorey and others of materials/storeys. Rayleigh damping then uses their
  /// initial stiffness.
  std::optional<PerStorey<StoreyLaw>> storey{};
  RayleighDamping damping{};  ///< Damping of the superstructure.
  /// > 0 kg; give it together with isolation.
  Mass base_mass{};
  /// The isolators under the base, with any law; fixed to the ground if left out.
  std::optional<Isolation> isolation{};
  /// Whether the weight above leaning columns acts: beside every storey a PDelta with storey_height.
  bool p_delta = false;
  /// > 0 m. For drawings, p_delta and neighbours.
  PerStorey<Length> storey_height = PerStorey<Length>::unless_given(3.5 * units::m);
  /// Overturning and vertical motion act on the bearings; left out: the weight on each is constant. Needs the heights.
  std::optional<AxialForces> axial_forces{};
  Length half_width = 5.0 * units::m;  ///< Half width of all floors, for drawings.
  Length x{};  ///< Position of the middle of all floors, for drawings and for buildings beside each other.
};

/// Adds nodes `base`, `floor 1` ..., elements `storey 1` ..., `bearings`, and the Building that it returns.
/// Throws InputError for a bad parameter or a name that is taken: a second building needs a name.
Building add(Model& model, const ShearBuilding& building);

}  // namespace moat
