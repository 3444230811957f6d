// The numbers of an impact, with name and unit: the one list behind impacts.csv, summary.json and report.html.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "output/case_result.hpp"

namespace moat {

/// A name of what met, in plan.
struct ImpactName {
  const char* name;
  std::string Impact::*value;
};

struct ImpactColumn {
  const char* name;
  const char* unit;  ///< SI symbol
  double Impact::*value;
  int least_decimals = 0;  ///< in the report
};

inline constexpr std::array impact_columns{
    ImpactColumn{"start", "s", &Impact::start, 4},
    ImpactColumn{"duration", "s", &Impact::duration},
    ImpactColumn{"approach_speed", "m/s", &Impact::approach_speed},
    ImpactColumn{"largest_indentation", "m", &Impact::largest_indentation},
    ImpactColumn{"largest_force", "N", &Impact::largest_force},
    ImpactColumn{"rebound_ratio", "1", &Impact::rebound_ratio},
    ImpactColumn{"restitution", "1", &Impact::restitution},
    ImpactColumn{"energy_lost", "J", &Impact::energy_lost},
};

/// The further ones in plan; a model on a line has none of them.
inline constexpr std::array impact_names_in_plan{ImpactName{"corner", &Impact::corner},
                                                 ImpactName{"edge", &Impact::edge}};
inline constexpr std::array impact_columns_in_plan{
    ImpactColumn{"tangential_speed", "m/s", &Impact::tangential_speed},
    ImpactColumn{"largest_friction_force", "N", &Impact::largest_friction_force},
    ImpactColumn{"friction_loss", "J", &Impact::friction_loss},
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
