// The gaps between two buildings beside each other.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "structures/any_impact_law.hpp"
#include "structures/neighbours/level_pairs.hpp"

namespace moat {

/// The free distance between two buildings at a height.
struct ClearanceAt {
  Length height;     ///< Above the ground.
  Length clearance;  ///< >= 0 m.
};

/// The free distance between two buildings: one, or a list over the height, linear between its entries.
///
///     .clearance = 10 * cm                                             everywhere
///     .clearance = {{4 * m, 10 * cm}, {15 * m, 16 * cm}}               facades that lean
///     .clearance = {{0 * m, 10 * cm}, {8 * m, 10 * cm}, {8.01 * m, 3 * m}, {15 * m, 3 * m}}    a setback above 8 m
class Clearance {
 public:
  /// A field that is left out does not compile, as with Required.
  Clearance() = delete;
  Clearance(Length everywhere) : list_{{{}, everywhere}} {}  ///< One clearance for every height.
  Clearance(std::initializer_list<ClearanceAt> over_height) : list_{over_height} {}  ///< From the lowest up.

  /// At a height, m. Throws InputError for heights that do not rise, and outside the heights of a list.
  [[nodiscard]] Length at(const Check& check, double height) const;

 private:
  std::vector<ClearanceAt> list_;
};

/// Two buildings beside each other on a line: every gap between them follows from the heights of their floors.
///
///      left                  right
///     [ floor 2 ]           [ floor 2 ]      floors whose levels differ by at most a slab's thickness meet
///        | |                   | |
///        | |                [ floor 1 ]      a floor at another height meets the column of the other building
///     [ floor 1 ]              | |           there: a point between two floors (MemberPoint)
///        | |                   | |
///     =bearings=               | |           the ground meets nothing: give a Moat around a base
///
///     add(model, Neighbours{.name = "joint", .left = hospital, .right = old, .clearance = 12 * cm,
///                           .law = ExactHertzDamp{.stiffness = 3e9 * N / m_3_2, .restitution = 0.6}});
///
/// Gaps are "joint: hospital floor 1 - old storey 2 at 4.20 m"; their impact forces share the place "joint". A level
/// below the lowest or above the highest one of the other building meets nothing.
struct Neighbours {
  std::string name = "neighbours";  ///< Unique in its model.
  Required<BuildingLevels> left;    ///< A building that add() returned, or a Building.
  Required<BuildingLevels> right;   ///< The other building.
  Clearance clearance;              ///< >= 0 m at rest; 0 is wall to wall.
  Required<AnyImpactLaw> law;       ///< The force of floors against floors.
  /// The force of floors against columns; left out: as `law`. A column is softer than a slab, and its own shear is not
  /// checked.
  std::optional<AnyImpactLaw> column_law{};
  Length slab = 30.0 * units::cm;  ///< >= 0 m: levels within it meet each other.
};

/// The gaps of two buildings.
struct NeighbourGaps {
  std::vector<std::string> names;  ///< Names of all gaps, from the lowest up.
  std::vector<std::string> notes;  ///< Sentences: levels that meet nothing, and columns with the law of slabs.
};

/// The remark about columns without a law of their own.
std::string note_on_columns(const std::string& name, std::size_t columns);

/// Adds all gaps. Throws InputError if there is none, for a model in plan, and as pairs_of_levels(), Clearance::at()
/// and the gaps do.
NeighbourGaps add(Model& model, const Neighbours& neighbours);

}  // namespace moat
