// A scaled suite of records as charts and as tables.
#pragma once

#include <vector>

#include "motions/spectra/scale_suite.hpp"
#include "output/charts/chart.hpp"
#include "output/files/table.hpp"

namespace moat {

/// Pseudo-accelerations over periods from 0.02 to 10 s, those of the target alone, with its corners: target, mean and
/// every scaled record; where each component is scaled, the smaller mean and both components.
[[nodiscard]] Table spectra_table(const ScaledSuite& suite);

/// Draws the spectra: records in one light colour, their mean in black, the target, fraction times target dashed, and
/// the range of scaling shaded; accelerations on logarithmic axes, and displacements S_a (T/(2 pi))^2.
[[nodiscard]] std::vector<Chart> suite_charts(const ScaledSuite& suite);

/// One row per record: its name, own factor, final factor, and peak accelerations of both scaled components.
[[nodiscard]] Table scaling_table(const ScaledSuite& suite);

}  // namespace moat
