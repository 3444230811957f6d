// The energies of a balance, with name and words: the one list behind summary.json, report, terminal and histories.
#pragma once

#include <array>
#include <span>

#include "output/files/case_result.hpp"

namespace moat {

/// One term of the balance of energies.
struct EnergyColumn {
  const char* name;              ///< in files
  const char* words;             ///< in the report
  double EnergyBalance::*value;  ///< its field, J
};

/// Where the input went: input = the sum of the others, but for errors. The last exists in plan only.
inline constexpr std::array all_energy_columns{
    EnergyColumn{"input", "Input by the ground", &EnergyBalance::input},
    EnergyColumn{"kinetic", "Kinetic, at the end", &EnergyBalance::kinetic},
    EnergyColumn{"strain", "Strain, at the end", &EnergyBalance::strain},
    EnergyColumn{"viscous", "Dissipated by viscous damping", &EnergyBalance::viscous},
    EnergyColumn{"hysteretic", "Dissipated by hysteresis", &EnergyBalance::hysteretic},
    EnergyColumn{"impact", "Lost in impacts", &EnergyBalance::impact},
    EnergyColumn{"friction", "Lost by friction along walls", &EnergyBalance::friction},
};
/// In their order; friction along walls in plan only.
inline constexpr std::span<const EnergyColumn> energy_columns(bool in_plan) {
  return std::span{all_energy_columns}.first(all_energy_columns.size() - (in_plan ? 0 : 1));
}

/// Errors, and the energies against which they are judged.
inline constexpr std::array energy_errors{
    EnergyColumn{"equation_residual", "Residual of the equations", &EnergyBalance::equation_residual},
    EnergyColumn{"integration_error", "Error of the integration", &EnergyBalance::integration_error},
    EnergyColumn{"largest_input", "Largest input", &EnergyBalance::largest_input},
    EnergyColumn{"largest_kinetic", "Largest kinetic", &EnergyBalance::largest_kinetic},
};

}  // namespace moat
