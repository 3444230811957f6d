// A building in plan: rigid floors with eccentric masses on columns and bearings.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "structures/per_storey.hpp"
#include "structures/plan_parts.hpp"
#include "structures/rayleigh_damping.hpp"

namespace moat {

/// A building of rigid floors that move in plan, on bearings or fixed to the ground.
///
///      elevation            plan
///     [ floor 2 ]           +--o-------o-------o--+
///        | |                |                     |   o column lines and bearings
///     [ floor 1 ]           |          x mass     |
///        | |                |                     |
///     [  base   ]           +--o-------o-------o--+
///     =bearings=
///
/// Floors have one outline, or each its own, which makes setbacks. Their masses are uniform over it but for
/// `mass_offset`, so that the rotary inertia about the centre of mass is that of the outline, unless it is given.
/// Rayleigh damping acts on the motion of the superstructure relative to its base: the stiffness part in every storey.
/// The mass part acts on the motion of every floor relative to the rigid motion of the base, at the floor's centre of
/// mass, and on its rotation relative to the base, reacting on the base. Its ratio holds in the lowest translational
/// mode of the superstructure held at its base, and in the next translational mode along the same direction; one storey
/// has one such mode, and then only the stiffness part. A symmetric building has the factors of a ShearBuilding.
struct PlanBuilding {
  /// Put before the names of all parts ("north base", "north floor 1") where a model has several buildings.
  std::string name{};
  PerStorey<PlanOutline> outline;  ///< Outline of each floor above the base, seen from above.
  /// >= 1.
  Required<int> storeys;
  /// > 0 kg, each floor above the base.
  PerStorey<Mass> floor_mass;
  /// Offset of each floor's centre of mass from the centroid of its outline.
  PerStorey<PlanPosition> mass_offset = PlanPosition{};
  /// > 0 kg m^2, of each floor about its centre of mass; left out: of a uniform floor.
  PerStorey<RotaryInertia> rotary_inertia = RotaryInertia{};
  PlanOutline base_outline{};  ///< Outline of the base; left out: that of floor 1.
  /// Offset of the base's centre of mass from the centroid of its outline.
  PlanPosition base_mass_offset{};
  RotaryInertia base_rotary_inertia{};  ///< > 0 kg m^2, about the base's centre of mass; left out: of a uniform floor.
  /// Lateral stiffness of each storey; a grid covers the outline of the floor above.
  PerStorey<PlanColumns> columns;
  RayleighDamping damping{};  ///< Damping of the superstructure.
  /// > 0 kg; give it together with bearings.
  Mass base_mass{};
  /// Under the base, a grid over its outline; fixed to the ground if left out.
  PlanBearings bearings{};
  /// > 0 m. For drawings, and for neighbours.
  PerStorey<Length> storey_height = PerStorey<Length>::unless_given(3.5 * units::m);
  /// Overturning and vertical motion act on the bearings; left out: the weight on each is constant. Needs the heights.
  std::optional<AxialForces> axial_forces{};
};

/// The parts of a building in plan that was added.
struct PlanBuildingParts {
  std::string name;  ///< Name of the building.
  DiaphragmId base;  ///< not specified() for a fixed building
  /// From the lowest up, without the base.
  Places<DiaphragmId, floors_remedy> floors;
  /// The positions of the columns of storeys 1, 2, ...; empty for a storey that is given as a whole.
  std::vector<std::vector<PlanPosition>> columns{};

  /// By its number in names: floor(1) is the lowest. Throws InputError outside 1 to the number of floors.
  [[nodiscard]] DiaphragmId floor(int number) const {
    return floors.numbered(number, Check{"PlanBuilding", name}, "floor");
  }
  /// Base, unless the building is fixed, and floors.
  [[nodiscard]] std::vector<DiaphragmId> diaphragms() const;
};

/// Adds diaphragms `base`, `floor 1` ..., columns `storey 1 column 1 x` ..., bearings `bearing 1` ... with the place
/// `bearings`, and the Building. Throws InputError for a bad parameter, a storey that does not resist every motion in
/// plan, or a name that is taken: a second building needs a name.
PlanBuildingParts add(Model& model, const PlanBuilding& building);

/// Factors that give `ratio` in two modes of these floors, everything else held: their lowest translational mode, and
/// the next translational mode in the same direction, of the elements that the model has so far. Floors with one such
/// mode get the stiffness part only. They are those of rayleigh_factors_of_chain() for a symmetric building. Throws
/// InputError for a ratio outside [0, 1) or no floors.
RayleighFactors rayleigh_factors_in_plan(double ratio, const Model& model, const std::vector<DiaphragmId>& floors);

/// Returns the stiffness of these floors for small motions, all others held: a row and a column for each of their
/// degrees of freedom, N/m.
Eigen::MatrixXd stiffness_of_floors(const Model& model, const std::vector<DiaphragmId>& floors);

/// All centres of mass moved along x and y by these shares of the extent of their outlines there, from where they are:
/// accidental eccentricity. ASCE 7 takes 5 % of the plan dimension across the motion.
PlanBuilding with_eccentricity(PlanBuilding building, double share_of_x, double share_of_y);

/// The four cases of accidental eccentricity: centres of mass moved by +-share along x, and by +-share along y.
std::array<PlanBuilding, 4> accidental_eccentricities(const PlanBuilding& building, double share = 0.05);

}  // namespace moat
