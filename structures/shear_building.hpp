// A building that shears: rigid floors, one spring per storey, isolated or fixed at its base.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elements/lead_rubber_bearing.hpp"
#include "model/model.hpp"
#include "structures/rayleigh_damping.hpp"

namespace moat {

/// A shear building on lead-rubber bearings, or fixed to the ground.
///
///     [ floor 5 ]     floor_mass
///        | |          storey_stiffness, Rayleigh damping
///        ...
///     [ floor 1 ]
///        | |
///     [  base   ]     base_mass                (none without isolation: the ground is the base)
///     ====LRB====     isolation
///
/// Rayleigh damping acts on the motion of the superstructure relative to its base: the stiffness part as
/// a dashpot in every storey, the mass part as a dashpot from every floor to the base, reacting on it.
struct ShearBuilding {
  /// Put before the names of all parts ("north base", "north floor 1") where a model has several buildings.
  std::string name{};
  /// >= 1.
  Required<int> storeys;
  /// > 0 kg, each floor above the base.
  Required<Mass> floor_mass;
  /// > 0 N/m, each storey.
  Required<Stiffness> storey_stiffness;
  RayleighDamping damping{};
  /// > 0 kg; give it together with isolation.
  Mass base_mass{};
  /// The bearings under the base; fixed to the ground if left out.
  std::optional<LeadRubberBearing> isolation{};
  /// For drawings only.
  Length storey_height = 3.5 * units::m;
  Length half_width = 5.0 * units::m;
  Length x{};
};

/// The nodes of a building that was added.
struct BuildingNodes {
  NodeId base;                 ///< `ground` for a fixed building
  std::vector<NodeId> floors;  ///< from floor 1 up
  [[nodiscard]] NodeId top() const { return floors.back(); }
};

/// Adds nodes `base`, `floor 1` ..., elements `storey 1` ..., `bearings`, and the report of base shear.
/// Throws InputError for a bad parameter or a name that is taken: a second building needs a name.
BuildingNodes add(Model& model, const ShearBuilding& building);

}  // namespace moat
