// Bearings of a building from a table.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "structures/plan_parts.hpp"

namespace moat {

/// A type of bearings: its name in the table, and its law.
struct BearingType {
  /// For every bearing of this type.
  template <BearingInPlan Bearing>
  BearingType(std::string type, Bearing law) : name{std::move(type)}, bearing{PlanPosition{}, std::move(law)} {}

  std::string name;              ///< As in the column `type`.
  PlanBearings::Placed bearing;  ///< The bearing of one line.
};

/// The types that a table of bearings may name.
struct BearingTypes {
  std::vector<BearingType> types;  ///< {{"LRB700", LeadRubberBearing{...}}, {"FPS", FrictionPendulum{...}}}
};

/// Reads a CSV table of bearings: `name,x [m],y [m],type`, and perhaps `weight [kN]`, in any order of columns; units as
/// in read_storeys(). Weights are those on the bearings; without them all carry the same share of the building.
///
///     .bearings = read_bearings("bearings.csv", {.types = {{"LRB700", LeadRubberBearing{...}}}})
///
/// A type that no bearing has is noted. Throws FileError naming file, line and remedy: a type that is not given, a name
/// that stands twice, a weight that is not > 0. Throws InputError for a type that is given twice.
PlanBearings read_bearings(const std::filesystem::path& file, const BearingTypes& types);

}  // namespace moat
