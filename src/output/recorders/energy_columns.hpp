// The energies of a balance, with name and words: the one list behind summary.json, report, terminal and histories.
#pragma once

#include <array>
#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

/// One term of the balance of energies.
struct EnergyColumn {
  const char* name;              ///< in files
  const char* words;             ///< in the report
  double EnergyBalance::*value;  ///< its field, J
};

/// Where the input went: input + weight_work = the sum of the others, but for errors.
inline constexpr std::array all_energy_columns{
    EnergyColumn{"input", "Input by the ground", &EnergyBalance::input},
    EnergyColumn{"weight_work", "Stored by weights that change, without work", &EnergyBalance::weight_work},
    EnergyColumn{"kinetic", "Kinetic, at the end", &EnergyBalance::kinetic},
    EnergyColumn{"strain", "Strain, at the end", &EnergyBalance::strain},
    EnergyColumn{"viscous", "Dissipated by viscous damping", &EnergyBalance::viscous},
    EnergyColumn{"hysteretic", "Dissipated by hysteresis", &EnergyBalance::hysteretic},
    EnergyColumn{"impact", "Lost in impacts", &EnergyBalance::impact},
    EnergyColumn{"friction", "Lost by friction along walls", &EnergyBalance::friction},
};
/// In their order: friction along walls in plan only, and the work of weights only where they change.
inline std::vector<EnergyColumn> energy_columns(bool in_plan, bool weights_change) {
  std::vector<EnergyColumn> columns;
  for (const EnergyColumn& column : all_energy_columns)
    if ((in_plan || column.value != &EnergyBalance::friction) &&
        (weights_change || column.value != &EnergyBalance::weight_work))
      columns.push_back(column);
  return columns;
}

/// Errors, and the energies against which they are judged.
inline constexpr std::array energy_errors{
    EnergyColumn{"equation_residual", "Residual of the equations", &EnergyBalance::equation_residual},
    EnergyColumn{"integration_error", "Error of the integration", &EnergyBalance::integration_error},
    EnergyColumn{"largest_input", "Largest input", &EnergyBalance::largest_input},
    EnergyColumn{"largest_kinetic", "Largest kinetic", &EnergyBalance::largest_kinetic},
};

}  // namespace moat
