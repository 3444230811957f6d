// The numbers of an impact, with name and unit: the one list behind impacts.csv, summary.json and report.html.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

/// A corner or an edge that met, in plan.
struct ImpactName {
  const char* name;            ///< of the column
  std::string Impact::*value;  ///< its field
};

/// A number of an impact.
struct ImpactColumn {
  const char* name;        ///< of the column
  const char* unit;        ///< SI symbol
  const char* meaning;     ///< a sentence for readers
  double Impact::*value;   ///< its field, in SI units
  int least_decimals = 0;  ///< in the report
};

/// The columns stand in this order.
inline constexpr std::array impact_columns{
    ImpactColumn{"start", "s", "Instant of the first touch.", &Impact::start, 4},
    ImpactColumn{"duration", "s", "From the first touch until the gap opens again.", &Impact::duration},
    ImpactColumn{"approach_speed", "m/s", "Speed at which the gap closed at the first touch.", &Impact::approach_speed},
    ImpactColumn{"largest_indentation", "m", "Largest overlap of the two sides.", &Impact::largest_indentation},
    ImpactColumn{"largest_force", "N", "Largest force between the two sides.", &Impact::largest_force},
    ImpactColumn{"rebound_ratio", "1",
                 "Speed of separation over speed of approach in this run, while the building pushes; it may exceed 1.",
                 &Impact::rebound_ratio},
    ImpactColumn{"restitution", "1", "The same ratio of the law alone, in free flight at the same speed of approach.",
                 &Impact::restitution},
    ImpactColumn{"energy_lost", "J", "Energy that the contact dissipated; in plan without friction.",
                 &Impact::energy_lost},
};

/// The further ones in plan; a model on a line has none of them.
inline constexpr std::array impact_names_in_plan{ImpactName{"corner", &Impact::corner},
                                                 ImpactName{"edge", &Impact::edge}};
/// The further numbers in plan.
inline constexpr std::array impact_columns_in_plan{
    ImpactColumn{"tangential_speed", "m/s", "Speed of the corner along the edge at the first touch.",
                 &Impact::tangential_speed},
    ImpactColumn{"largest_friction_force", "N", "Largest force along the edge.", &Impact::largest_friction_force},
    ImpactColumn{"friction_loss", "J", "Energy that friction along the edge dissipated.", &Impact::friction_loss},
};

/// Whether impacts are those of corners with edges.
inline bool are_in_plan(const std::vector<Impact>& impacts) {
  return !impacts.empty() && !impacts.front().edge.empty();
}

/// The columns of a table of these impacts.
inline std::vector<ImpactColumn> columns_of(const std::vector<Impact>& impacts) {
  std::vector<ImpactColumn> columns{impact_columns.begin(), impact_columns.end()};
  if (are_in_plan(impacts)) columns.insert(columns.end(), impact_columns_in_plan.begin(), impact_columns_in_plan.end());
  return columns;
}

}  // namespace moat
