// Which floors of a building can hit which floors and columns of another, by their heights.
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/plan_outline.hpp"

namespace moat {

/// A building beside another one: any that add() returned, a Building made of nodes or diaphragms, or one floor.
struct BuildingLevels {
  std::string name;  ///< Name of the building; empty for a floor.
  /// The base, or `ground` for a fixed building, and the floors from the lowest up: level i carries storey i + 1.
  std::vector<NodeId> levels;
  /// In plan: the positions of the columns of storeys 1, 2, ...; empty where they are not known.
  std::vector<std::vector<PlanPosition>> columns{};

  /// All parts of a building that have these names.
  template <class Parts>
  requires requires(const Parts& parts) {
    { parts.name } -> std::convertible_to<std::string>;
    { parts.base } -> std::convertible_to<NodeId>;
    { parts.floors.front() } -> std::convertible_to<NodeId>;
  }
  BuildingLevels(const Parts& parts) : name{parts.name} {
    const NodeId base = parts.base;
    levels.push_back(base.specified() ? base : ground);
    for (const NodeId floor : parts.floors) levels.push_back(floor);
    if constexpr (requires { parts.columns; }) columns = parts.columns;
  }

  /// One floor in plan.
  BuildingLevels(DiaphragmId floor) : levels{floor} {}

  /// Returns the name, else that of the highest level, in quotation marks.
  [[nodiscard]] std::string title(const Model& model) const;
  /// "hospital storey 2", by its number in names.
  [[nodiscard]] std::string storey_name(std::size_t storey) const;
};

/// A floor of one of two buildings, and the floor or the column of the other one that it can hit.
struct LevelPair {
  bool of_first = true;   ///< Whether the floor is one of the first building.
  std::size_t floor = 0;  ///< Level of this floor.
  std::size_t other = 0;  ///< The level of the other building that it meets, or the one above the point of its column.
  double share = 1.0;     ///< Share of the level above in the motion of the point, > 0; 1 where two floors meet.
  double height = 0.0;    ///< m, of the contact

  [[nodiscard]] bool is_at_column() const { return share < 1.0; }  ///< Whether the floor meets a column.
};

/// All pairs of two buildings from the lowest up, and remarks about levels that meet nothing.
struct LevelPairs {
  std::vector<LevelPair> pairs;    ///< From the lowest up.
  std::vector<std::string> notes;  ///< Sentences for the user.
};

/// Two levels whose heights differ by no more than `slab` meet each other, also one with two. A level without such a
/// partner meets the column of the storey of the other building at its height, if there is one. The ground meets
/// nothing. Throws InputError for levels that are not of this model or that do not rise, a slab < 0 m, and buildings
/// with a common floor. `check` names the object.
LevelPairs pairs_of_levels(const Model& model, const Check& check, const BuildingLevels& first,
                           const BuildingLevels& second, Length slab);

/// Says that two buildings have no pair.
std::string no_pair(const Model& model, const BuildingLevels& first, const BuildingLevels& second);

/// The point at the upper level `upper` >= 1 and the one below, with this share of the upper one: a floor where it
/// is 1. A point between the ground and a floor begins at the floor.
MemberPoint point_of_column(const BuildingLevels& building, std::size_t upper, double share);

}  // namespace moat
