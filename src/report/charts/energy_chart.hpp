// The energies of a run over time, as a stack.
#pragma once

#include <optional>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// Dissipated energies, strain and kinetic energy on top of each other, and the input as a line: the stack reaches it
/// but for errors. None where the histories have no energies.
std::optional<Chart> energy_chart(const CaseResult& result);

}  // namespace moat
