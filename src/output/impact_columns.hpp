// The numbers of an impact, with name and unit: the one list behind impacts.csv, summary.json and report.html.
#pragma once

#include <array>

#include "output/case_result.hpp"

namespace moat {

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

}  // namespace moat
