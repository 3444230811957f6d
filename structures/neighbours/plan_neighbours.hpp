// The contacts of two floors or two buildings beside each other in plan.
#pragma once

#include <optional>
#include <string>

#include "structures/neighbours/neighbours.hpp"

namespace moat {

/// Two floors beside each other, at any angle, or two buildings: every contact between them follows from the outlines
/// and heights of their floors, and their clearances from the outlines.
///
/// Floors meet with their corners: those of each hit edges of the other. Elements are "<name> second corner 3 first
/// edge 1" and so on. Two floors that are given themselves meet at any heights; those of buildings meet
/// where their levels differ by at most a slab's thickness.
///
///      elevation                   plan
///     [ floor 2 ]                 +-----------+
///        | |                      |  floor 1  |  o      o    the columns of the next row are left out
///        | | <--- [floor 1 ]      |    edge 2 ->
///     [ floor 1 ]    | |          |           |  o      o    columns within 1 m of the outline around them
///                                 +-----------+
///
/// A floor at another height meets the columns of the other building's storey there with its edges. A point of a column
/// moves with the shares of the floors above and below at its place (PlanPoint::other). Columns are those of a
/// PlanBuilding; where their positions are not known, the corners of the floor above stand for them. Columns never meet
/// columns, and a floor that fits between two columns meets none of them. The ground meets nothing: give a PlanMoat
/// around a base.
///
///     add(model, PlanNeighbours{.name = "joint", .first = hospital, .second = old, .law = HertzDamp{...}});
struct PlanNeighbours {
  std::string name = "neighbours";  ///< Unique in its model.
  /// Diaphragms with outlines, or buildings of such.
  Required<BuildingLevels> first;
  Required<BuildingLevels> second;  ///< The other floor or building.
  Required<AnyImpactLaw> law;       ///< The force of floors against floors.
  /// The force of floors against columns; left out: as `law`. A column is softer than a slab, and its own shear is not
  /// checked.
  std::optional<AnyImpactLaw> column_law{};
  CornerFriction friction{};  ///< Along the edges.
  /// > 0 m: pairs farther apart are left out.
  Length reach = 1.0 * units::m;
  Length slab = 30.0 * units::cm;  ///< >= 0 m: levels of buildings within it meet each other.
};

/// Adds all contacts. Throws InputError for floors without outline, outlines that overlap and columns inside a floor,
/// if there is no contact, and as pairs_of_levels() and add(Model&, CornerGap) do.
NeighbourGaps add(Model& model, const PlanNeighbours& neighbours);

}  // namespace moat
