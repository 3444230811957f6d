// A chart in words, for readers who do not see it.
#pragma once

#include <string>
#include <vector>

#include "output/charts/chart_panel.hpp"

namespace moat {

/// "Displacement; Impact force".
std::string titles_of(const std::vector<ChartPanel>& panels);

/// A sentence for each chart: "Displacement: displacement [cm] over time [s]; base from -13.5 to 14.2, ...".
std::string description_of(const std::vector<ChartPanel>& panels);

}  // namespace moat
