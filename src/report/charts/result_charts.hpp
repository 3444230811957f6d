// All charts of a run, for the report and as files.
#pragma once

#include <filesystem>
#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// All charts of a run.
struct ResultCharts {
  std::vector<Chart> histories;       ///< report/charts/history_charts.hpp
  std::vector<Chart> floor_profiles;  ///< report/charts/floor_profiles.hpp
  std::vector<Chart> isolator_loops;  ///< report/charts/isolator_loops.hpp
  std::vector<Chart> impact_loops;    ///< report/charts/impact_loops.hpp
  std::vector<Chart> energy;          ///< report/charts/energy_chart.hpp, at most one
  std::vector<Chart> floor_spectra;   ///< report/charts/floor_spectra.hpp
  std::vector<Chart> orbits;  ///< report/charts/orbit_charts.hpp; the report has report/charts/plan_view.hpp instead

  /// All of them, in this order.
  [[nodiscard]] std::vector<const Chart*> all() const;
};

/// Throws InputError where columns of the histories differ in length.
ResultCharts result_charts(const CaseResult& result);

/// For papers: `charts/<title>.svg` and `charts/<title>.csv`, the numbers of its curves, for every chart, and
/// charts.svg with all histories. Names of files have small letters, digits and underscores. Throws FileError.
void write_charts(const ResultCharts& charts, const std::filesystem::path& folder);

}  // namespace moat
